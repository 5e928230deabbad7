"""Empty lists from YAML, which don't have the type of their items: it is that of the node's declared parameter."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.interfaces.rcl_interfaces.msg import Parameter, ParameterDescriptor

__all__ = ["give_declared_types", "give_types", "untyped_names"]

_BYTE_ARRAY = 5
"""The constant of `rcl_interfaces/msg/ParameterType`, the lowest of those of arrays."""


def untyped_names(parameters: Iterable[Parameter]) -> list[str]:
    """Return the names of those whose value is an empty list that was read from YAML, which is a BYTE_ARRAY."""
    return [parameter.name for parameter in parameters if _is_untyped(parameter)]


def give_declared_types(
    parameters: Sequence[Parameter], describe: Callable[[str], Iterable[ParameterDescriptor]]
) -> None:
    """Give the empty lists among them the types that a node has for them.

    Args:
        parameters: The parameters, which are changed.
        describe: Waits for the node's response, and returns its descriptors of a parameter. It is called for one name
            at a time, because a node returns none if one of several names isn't declared.
    """
    types: dict[str, int] = {}
    for name in untyped_names(parameters):
        types.update((descriptor.name, descriptor.type) for descriptor in describe(name))
    give_types(parameters, types)


def give_types(parameters: Iterable[Parameter], types: Mapping[str, int]) -> None:
    """Give the empty lists among them the types of a node's descriptors, by name; where there is none, they stay.

    A parameter that was declared by its type has this type there, also while it has no value.
    """
    for parameter in parameters:
        if _is_untyped(parameter):
            parameter.value.type = max(types.get(parameter.name, 0), _BYTE_ARRAY)


def _is_untyped(parameter: Parameter) -> bool:
    return parameter.value.type == _BYTE_ARRAY and not parameter.value.byte_array_value
