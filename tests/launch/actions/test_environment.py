"""Environment variables: set, removed, appended to, scoped and reset."""

from __future__ import annotations

import os

import pytest

from tfloom.launch.actions.environment import (
    AppendEnvironmentVariable,
    PopEnvironment,
    PushEnvironment,
    ReplaceEnvironmentVariables,
    ResetEnvironment,
    SetEnvironmentVariable,
    UnsetEnvironmentVariable,
)
from tfloom.launch.core.base_classes import SubstitutionFailure, TextSubstitution
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.substitutions.variables import EnvironmentVariable, LaunchConfiguration

NAME = "TFLOOM_LAUNCH_TEST"


def test_variable_is_set_for_later_processes_and_removed(context: LaunchContext) -> None:
    context.launch_configurations["value"] = "one"
    SetEnvironmentVariable(["TFLOOM_", "LAUNCH_TEST"], LaunchConfiguration("value")).visit(context)
    assert os.environ[NAME] == context.environment[NAME] == "one"
    UnsetEnvironmentVariable(NAME).visit(context)
    UnsetEnvironmentVariable(NAME).visit(context)
    assert NAME not in os.environ


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({}, f"one{os.pathsep}two"),
        ({"prepend": True}, f"two{os.pathsep}one"),
        ({"separator": " "}, "one two"),
        ({"prepend": TextSubstitution(text="yes"), "separator": ["<", ">"]}, "two<>one"),
        ({"prepend": [LaunchConfiguration("no")]}, f"one{os.pathsep}two"),
    ],
)
def test_appending(options: dict[str, object], expected: str, context: LaunchContext) -> None:
    context.launch_configurations["no"] = "false"
    AppendEnvironmentVariable(NAME, "one", **options).visit(context)
    assert os.environ[NAME] == "one"
    AppendEnvironmentVariable(NAME, "two", **options).visit(context)
    assert os.environ[NAME] == expected


def test_scopes_and_reset() -> None:
    os.environ[NAME] = "start"
    context = LaunchContext()
    PushEnvironment().visit(context)
    SetEnvironmentVariable(NAME, "inner").visit(context)
    ResetEnvironment().visit(context)
    assert os.environ[NAME] == "start"
    SetEnvironmentVariable("TFLOOM_LAUNCH_OTHER", "inner").visit(context)
    PopEnvironment().visit(context)
    assert os.environ[NAME] == "start"
    assert "TFLOOM_LAUNCH_OTHER" not in os.environ


def test_all_variables_are_replaced_within_a_scope() -> None:
    os.environ[NAME] = "start"
    context = LaunchContext()
    context.launch_configurations["value"] = "one"
    PushEnvironment().visit(context)
    action = ReplaceEnvironmentVariables(
        {("TFLOOM_", "LAUNCH_OTHER"): LaunchConfiguration("value"), "HERE": EnvironmentVariable(NAME)}
    )
    action.visit(context)
    assert dict(os.environ) == {"TFLOOM_LAUNCH_OTHER": "one", "HERE": "start"}
    ReplaceEnvironmentVariables().visit(context)
    assert not os.environ
    PopEnvironment().visit(context)
    assert os.environ[NAME] == "start"
    assert "PATH" in os.environ


def test_variables_stay_where_a_value_of_their_replacement_is_missing(context: LaunchContext) -> None:
    before = dict(os.environ)
    with pytest.raises(SubstitutionFailure, match="nowhere"):
        ReplaceEnvironmentVariables({"A": LaunchConfiguration("nowhere")}).visit(context)
    assert dict(os.environ) == before
    for name, value in (("A=B", "1"), ("", "1"), ("A", "\0")):
        with pytest.raises(ValueError, match=f"can't be replaced by one of 'OK', {name!r}: "):
            ReplaceEnvironmentVariables({"OK": "1", name: value}).visit(context)
        assert dict(os.environ) == before
