"""The parts of the verbs about parameters that need no node."""

from __future__ import annotations

from typing import Any

import pytest

from tfloom.cli.param.dump import nested
from tfloom.cli.param.queries import description_lines
from tfloom.interfaces.rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor


@pytest.mark.parametrize(
    ("flat", "tree"),
    [
        ({}, {}),
        ({"a": 1, "b.c": 2, "b.d.e": 3}, {"a": 1, "b": {"c": 2, "d": {"e": 3}}}),
        ({"a": 1, "a.b": 2, "a.b.c": 3}, {"a": 1, "a.b": 2, "a.b.c": 3}),
    ],
)
def test_names_with_dots_become_nested_mappings(flat: dict[str, Any], tree: dict[str, Any]) -> None:
    assert nested(flat) == tree


def test_constraints_are_printed() -> None:
    limits = FloatingPointRange(from_value=0.5, to_value=2.0)
    descriptor = ParameterDescriptor(
        name="gain", type=3, read_only=True, floating_point_range=[limits], additional_constraints="odd"
    )
    assert list(description_lines(descriptor)) == [
        "Parameter name: gain",
        "  Type: double",
        "  Constraints:",
        "    Read only: true",
        "    Min value: 0.5",
        "    Max value: 2.0",
        "    Additional constraints: odd",
    ]
