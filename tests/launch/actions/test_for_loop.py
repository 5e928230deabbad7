"""Loops over sets of values, and loops of a length."""

from __future__ import annotations

from typing import Any

import pytest

from tfloom.launch.actions.for_loop import ForEach, ForLoop
from tfloom.launch.actions.launch_configurations import SetLaunchConfiguration
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.substitutions.variables import LaunchConfiguration
from tfloom.launch.utilities.visits import visit_all_entities_and_collect_futures


def called(loop: Any, **configurations: str) -> dict[str, str]:
    context = LaunchContext()
    context.launch_configurations.update(configurations)
    visit_all_entities_and_collect_futures(loop, context)
    return context.launch_configurations


def test_each_set_of_values_is_given_by_keyword() -> None:
    sets: list[tuple[str, object]] = []

    def add(name: str, id: int = 7) -> list[SetLaunchConfiguration]:  # noqa: A002
        sets.append((name, id))
        return [SetLaunchConfiguration(name, str(id))]

    loop = ForEach(LaunchConfiguration("robots"), function=add)
    found = called(loop, robots=" {name: 'a', id: 1}; {id: 2, name: b};{name: c};")
    assert sets == [("a", 1), ("b", 2), ("c", 7)]
    assert found == {
        "robots": " {name: 'a', id: 1}; {id: 2, name: b};{name: c};",
        "a": "1",
        "b": "2",
        "c": "7",
    }


@pytest.mark.parametrize(("text", "times"), [("", 0), (" ", 0), ("{}", 1), ("{};{}", 2)])
def test_no_sets_and_empty_sets(text: str, times: int) -> None:
    calls: list[None] = []
    called(ForEach(text, function=lambda: calls.append(None)))
    assert len(calls) == times


@pytest.mark.parametrize("text", ["a", "[1, 2]", "1"])
def test_a_set_that_is_no_mapping_is_an_error(text: str) -> None:
    with pytest.raises(ValueError, match=f"must be YAML mappings .* not '{text}'".replace("[", r"\[")):
        called(ForEach(text, function=lambda: None))


def test_length_may_be_an_argument() -> None:
    loop = ForLoop(LaunchConfiguration("n"), function=lambda i: [SetLaunchConfiguration(f"i{i}", str(i))])
    assert called(loop, n="3") == {"n": "3", "i0": "0", "i1": "1", "i2": "2"}
    assert called(loop, n="0") == {"n": "0"}


def test_length_that_is_no_number_is_an_error() -> None:
    with pytest.raises(ValueError, match="whole number, not 'many'"):
        called(ForLoop("many", function=lambda i: None))


def test_descriptions_and_properties() -> None:
    def function(i: int) -> None:
        """Return nothing."""

    loop, for_each = ForLoop("2", function=function, name="i"), ForEach("{}", function=function)
    assert (loop.name, loop.function, for_each.function) == ("i", function, function)
    assert loop.describe().startswith("ForLoop(length='[")
    assert for_each.describe().startswith("ForEach(input_values='[")
    assert [part.describe() for part in (*loop.length, *for_each.input_values)] == ["'2'", "'{}'"]
