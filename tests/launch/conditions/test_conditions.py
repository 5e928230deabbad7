"""Conditions: texts that are true or false, and values of launch configurations."""

from __future__ import annotations

import pytest

from tfloom.launch.core.base_classes import TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.conditions import (
    IfCondition,
    InvalidConditionExpressionError,
    LaunchConfigurationEquals,
    LaunchConfigurationNotEquals,
    UnlessCondition,
    evaluate_condition_expression,
)
from tfloom.launch.substitutions.variables import LaunchConfiguration


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("true", True),
        ("True", True),
        (" TRUE ", True),
        ("1", True),
        ("false", False),
        ("0", False),
        ("False\n", False),
    ],
)
def test_text_is_true_or_false(text: str, value: bool, context: LaunchContext) -> None:
    context.launch_configurations["x"] = text
    assert IfCondition(text).evaluate(context) is value
    assert IfCondition([LaunchConfiguration("x")]).evaluate(context) is value
    assert UnlessCondition(text).evaluate(context) is not value
    # As launch files of others ask, rtabmap's among them.
    assert IfCondition(text)._predicate_func(context) is value
    assert UnlessCondition(text)._predicate_func(context) is not value
    assert evaluate_condition_expression(context, [TextSubstitution(text=text)]) is value


@pytest.mark.parametrize("text", ["", "yes", "2", "truefalse"])
@pytest.mark.parametrize("kind", [IfCondition, UnlessCondition])
def test_other_texts_are_errors(text: str, kind: type[IfCondition], context: LaunchContext) -> None:
    context.launch_configurations["x"] = text
    with pytest.raises(InvalidConditionExpressionError) as raised:
        kind(LaunchConfiguration("x")).evaluate(context)
    assert isinstance(raised.value, ValueError)
    assert str(raised.value) == (
        f"invalid condition expression, expected one of [true, 1, false, 0] but got '{text}', "
        "expanded from 'LaunchConfig('x')'"
    )


def test_description() -> None:
    assert IfCondition(["tr", "ue"]).describe() == "IfCondition('tr' + 'ue')"
    assert UnlessCondition("0").describe() == "UnlessCondition('0')"


@pytest.mark.parametrize(
    ("expected", "is_equal"),
    [("world", True), ([TextSubstitution(text="wor"), "ld"], True), ("moon", False), (None, False)],
)
def test_value_of_a_launch_configuration(expected: str, is_equal: bool, context: LaunchContext) -> None:
    context.launch_configurations["who"] = "world"
    with pytest.warns(UserWarning, match="EqualsSubstitution"):
        equals = LaunchConfigurationEquals("who", expected)
    with pytest.warns(UserWarning, match="EqualsSubstitution"):
        differs = LaunchConfigurationNotEquals("who", expected)
    assert equals.evaluate(context) is is_equal
    assert differs.evaluate(context) is not is_equal


@pytest.mark.filterwarnings("ignore:.*EqualsSubstitution")
def test_launch_configuration_that_is_not_set(context: LaunchContext) -> None:
    assert LaunchConfigurationEquals("who", None).evaluate(context)
    assert not LaunchConfigurationEquals("who", "").evaluate(context)
    assert not LaunchConfigurationNotEquals("who", None).evaluate(context)
    assert LaunchConfigurationNotEquals("who", "x").evaluate(context)
