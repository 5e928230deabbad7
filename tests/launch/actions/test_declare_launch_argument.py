"""Declared arguments: defaults, choices, and the errors."""

from __future__ import annotations

import pytest

from tfloom.launch.actions.declare_launch_argument import DeclareBooleanLaunchArgument, DeclareLaunchArgument
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.substitutions.variables import LaunchConfiguration


def test_default_is_performed_when_no_value_was_given(context: LaunchContext) -> None:
    context.launch_configurations["other"] = "one"
    DeclareLaunchArgument("a", default_value=["of ", LaunchConfiguration("other")]).visit(context)
    assert context.launch_configurations["a"] == "of one"
    DeclareLaunchArgument("a", default_value="two").visit(context)
    assert context.launch_configurations["a"] == "of one"


def test_empty_default_is_a_value(context: LaunchContext) -> None:
    DeclareLaunchArgument("a", default_value="").visit(context)
    assert context.launch_configurations["a"] == ""


def test_no_value_is_an_error_that_names_the_argument() -> None:
    with pytest.raises(RuntimeError, match=r'^Required launch argument "need" was not provided\.$'):
        DeclareLaunchArgument("need", description="what for").visit(LaunchContext())


@pytest.mark.parametrize(
    ("options", "description"),
    [
        ({}, "no description given"),
        ({"description": "what for"}, "what for"),
        ({"choices": ["a", "b"]}, "One of: ['a', 'b']"),
        ({"choices": ["a"], "description": "what for"}, "what for. Valid choices are: ['a']"),
        ({"choices": ["a"], "description": "what for."}, "what for. Valid choices are: ['a']"),
    ],
)
def test_description_names_the_choices(options: dict[str, object], description: str) -> None:
    assert DeclareLaunchArgument("x", **options).description == description


def test_value_must_be_one_of_the_choices(context: LaunchContext) -> None:
    argument = DeclareLaunchArgument("mode", choices=["a", "b"], default_value="a")
    argument.visit(context)
    assert argument.choices == ["a", "b"]
    context.launch_configurations["mode"] = "c"
    with pytest.raises(RuntimeError) as error:
        argument.visit(context)
    assert str(error.value) == (
        "Argument \"mode\" provided value \"c\" is not valid. Valid options are: ['a', 'b']"
    )


def test_choices_are_checked_when_they_are_declared() -> None:
    with pytest.raises(RuntimeError, match=r'default_value "c" is not in provided choices "\[\'a\'\]"'):
        DeclareLaunchArgument("mode", choices=["a"], default_value="c")
    with pytest.raises(RuntimeError, match="choices arg is empty"):
        DeclareLaunchArgument("mode", choices=[])
    later = DeclareLaunchArgument("mode", choices=["a"], default_value=TextSubstitution(text="c"))
    with pytest.raises(RuntimeError, match='"c" is not valid'):
        later.visit(LaunchContext())


def test_boolean_argument_takes_booleans_alone(context: LaunchContext) -> None:
    argument = DeclareBooleanLaunchArgument("gui", default_value=True, description="Show a window.")
    assert argument.choices == ["true", "false", "True", "False", "TRUE", "FALSE"]
    assert argument.description.startswith("Show a window. Valid choices are: ['true', ")
    argument.visit(context)
    assert context.launch_configurations["gui"] == "true"
    DeclareBooleanLaunchArgument("other", default_value=[LaunchConfiguration("gui")]).visit(context)
    assert context.launch_configurations["other"] == "true"
    context.launch_configurations["gui"] = "yes"
    with pytest.raises(RuntimeError, match='Argument "gui" provided value "yes" is not valid'):
        argument.visit(context)


@pytest.mark.parametrize("choices", [["true"], None])
def test_boolean_argument_has_its_own_choices(choices: list[str] | None) -> None:
    with pytest.raises(ValueError, match=r"^Cannot specify choices for bool_arg$"):
        DeclareBooleanLaunchArgument("gui", choices=choices)
    with pytest.raises(RuntimeError, match='"1" is not in provided choices'):
        DeclareBooleanLaunchArgument("gui", default_value="1")
