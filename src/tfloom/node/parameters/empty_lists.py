"""Empty lists from YAML, which don't tell the type of their items: the node that has the parameter tells it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import Parameter

__all__ = ["give_types", "untyped_names"]

_BYTE_ARRAY = 5
"""The constant of `rcl_interfaces/msg/ParameterType`, the lowest of those of arrays."""


def untyped_names(parameters: Iterable[Parameter]) -> list[str]:
    """Return the names of those whose value is an empty list that was read from YAML, which is a BYTE_ARRAY."""
    return [parameter.name for parameter in parameters if _is_untyped(parameter)]


def give_types(parameters: Iterable[Parameter], types: Mapping[str, int]) -> None:
    """Give the empty lists among them the types of a node's descriptors, by name; where there is none, they stay.

    A parameter that was declared by its type has this type there, also while it has no value.
    """
    for parameter in parameters:
        if _is_untyped(parameter):
            parameter.value.type = max(types.get(parameter.name, 0), _BYTE_ARRAY)


def _is_untyped(parameter: Parameter) -> bool:
    return parameter.value.type == _BYTE_ARRAY and not parameter.value.byte_array_value
