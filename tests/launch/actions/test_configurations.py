"""Launch configurations: set, removed, scoped and reset."""

from __future__ import annotations

from tfloom.launch.actions.launch_configurations import (
    PopLaunchConfigurations,
    PushLaunchConfigurations,
    ResetLaunchConfigurations,
    SetLaunchConfiguration,
    UnsetLaunchConfiguration,
)
from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.substitutions.variables import LaunchConfiguration


def test_name_and_value_are_performed(context: LaunchContext) -> None:
    SetLaunchConfiguration("a", "one").visit(context)
    SetLaunchConfiguration(["b_", LaunchConfiguration("a")], LaunchConfiguration("a")).visit(context)
    assert context.launch_configurations == {"a": "one", "b_one": "one"}
    SetLaunchConfiguration("a", "two").visit(context)
    assert context.launch_configurations["a"] == "two"


def test_properties_are_lists_of_substitutions() -> None:
    action = SetLaunchConfiguration("a", "one")
    assert [part.describe() for part in (*action.name, *action.value)] == ["'a'", "'one'"]
    assert [part.describe() for part in UnsetLaunchConfiguration(TextSubstitution(text="a")).name] == ["'a'"]


def test_removing_one_that_is_not_set_is_no_error(context: LaunchContext) -> None:
    context.launch_configurations.update(a="one", b="two")
    UnsetLaunchConfiguration(LaunchConfiguration("a")).visit(context)
    assert context.launch_configurations == {"a": "one", "b": "two"}
    UnsetLaunchConfiguration("a").visit(context)
    assert context.launch_configurations == {"b": "two"}


def test_scopes_are_nested(context: LaunchContext) -> None:
    context.launch_configurations["a"] = "outer"
    PushLaunchConfigurations().visit(context)
    context.launch_configurations["a"] = "middle"
    PushLaunchConfigurations().visit(context)
    context.launch_configurations.update(a="inner", b="inner")
    PopLaunchConfigurations().visit(context)
    assert context.launch_configurations == {"a": "middle"}
    PopLaunchConfigurations().visit(context)
    assert context.launch_configurations == {"a": "outer"}


def test_reset_keeps_what_was_performed_before(context: LaunchContext) -> None:
    context.launch_configurations.update(a="one", b="two")
    ResetLaunchConfigurations({"a": LaunchConfiguration("b"), LaunchConfiguration("a"): "c"}).visit(context)
    assert context.launch_configurations == {"a": "two", "one": "c"}
    for empty in (None, {}):
        context.launch_configurations["a"] = "one"
        ResetLaunchConfigurations(empty).visit(context)
        assert context.launch_configurations == {}
