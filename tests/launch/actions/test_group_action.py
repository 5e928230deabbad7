"""Groups: their conditions and their scopes."""

from __future__ import annotations

from typing import Any

import pytest

from tfloom.launch.actions.environment import SetEnvironmentVariable
from tfloom.launch.actions.group_action import GroupAction
from tfloom.launch.actions.launch_configurations import SetLaunchConfiguration
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.conditions import IfCondition
from tfloom.launch.substitutions.variables import LaunchConfiguration
from tfloom.launch.utilities.visits import visit_all_entities_and_collect_futures

NAME = "TFLOOM_LAUNCH_TEST"


def inner_and_outer(**options: Any) -> tuple[dict[str, str], dict[str, str]]:
    """Return the launch configurations that an action in a group has, and those after the group."""
    context = LaunchContext()
    context.launch_configurations["a"] = "outer"
    configurations: list[dict[str, str]] = []

    def see(context: LaunchContext) -> None:
        configurations.append(dict(context.launch_configurations))

    actions = [SetLaunchConfiguration("b", "inner"), OpaqueFunction(function=see)]
    visit_all_entities_and_collect_futures(GroupAction(actions, **options), context)
    return configurations[0], dict(context.launch_configurations)


@pytest.mark.parametrize(
    ("options", "inner", "after"),
    [
        ({}, {"a": "outer", "b": "inner"}, {"a": "outer"}),
        ({"scoped": False}, {"a": "outer", "b": "inner"}, {"a": "outer", "b": "inner"}),
        ({"forwarding": False}, {"b": "inner"}, {"a": "outer"}),
        (
            {"launch_configurations": {"c": LaunchConfiguration("a")}},
            {"a": "outer", "b": "inner", "c": "outer"},
            {"a": "outer"},
        ),
        (
            {"launch_configurations": {"c": LaunchConfiguration("a")}, "forwarding": False},
            {"b": "inner", "c": "outer"},
            {"a": "outer"},
        ),
        (
            {"launch_configurations": {"c": "of the group"}, "scoped": False},
            {"a": "outer", "b": "inner", "c": "of the group"},
            {"a": "outer", "b": "inner", "c": "of the group"},
        ),
    ],
)
def test_scope(options: dict[str, Any], inner: dict[str, str], after: dict[str, str]) -> None:
    assert inner_and_outer(**options) == (inner, after)


def test_environment_is_scoped(context: LaunchContext) -> None:
    values: list[str | None] = []

    def see(context: LaunchContext) -> None:
        values.append(context.environment.get(NAME))

    group = GroupAction([SetEnvironmentVariable(NAME, "inner"), OpaqueFunction(function=see)])
    visit_all_entities_and_collect_futures(group, context)
    see(context)
    assert values == ["inner", None]


def test_a_group_without_forwarding_starts_with_the_first_environment(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv(NAME, "first")
    context = LaunchContext()
    values: list[str | None] = []

    def see(context: LaunchContext) -> None:
        values.append(context.environment.get(NAME))

    SetEnvironmentVariable(NAME, "outer").visit(context)
    group = GroupAction([OpaqueFunction(function=see)], forwarding=False)
    visit_all_entities_and_collect_futures(group, context)
    see(context)
    assert values == ["first", "outer"]


def test_condition_holds_for_all_actions(context: LaunchContext) -> None:
    group = GroupAction(
        [SetLaunchConfiguration("a", "1"), SetLaunchConfiguration("b", "1")],
        scoped=False,
        condition=IfCondition("false"),
    )
    visit_all_entities_and_collect_futures(group, context)
    assert context.launch_configurations == {}


def test_a_group_is_visited_twice(context: LaunchContext) -> None:
    group = GroupAction(iter([SetLaunchConfiguration("a", "1")]), scoped=False)
    for _ in range(2):
        context.launch_configurations.clear()
        visit_all_entities_and_collect_futures(group, context)
        assert context.launch_configurations == {"a": "1"}
