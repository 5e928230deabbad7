"""The tuples that `declare_parameters` takes."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any, NamedTuple

from tfloom.interfaces.rcl_interfaces import msg as rcl_msg
from tfloom.node.parameters.parameter import (
    PARAMETER_SEPARATOR_STRING,
    Parameter,
    ParameterType,
    parameter_value_to_python,
)

__all__ = ["Declaration", "read_declarations"]


class Declaration(NamedTuple):
    """A parameter to declare."""

    name: str
    default: Any
    """None: it has no default."""
    descriptor: rcl_msg.ParameterDescriptor


def read_declarations(namespace: str, parameters: Sequence[tuple[Any, ...]]) -> list[Declaration]:
    """Return the declarations in tuples of (name), (name, value or type) or (name, value or type, descriptor).

    Raises:
        TypeError: a tuple isn't of that form.
        ValueError: a type is NOT_SET, or given together with dynamic typing; or there is neither value nor type,
            and no dynamic typing.
    """
    return [_read_declaration(index, namespace, parameter) for index, parameter in enumerate(parameters)]


def _read_declaration(index: int, namespace: str, entry: tuple[Any, ...]) -> Declaration:
    where = f"at index {index} in parameters list: {entry}"
    if not 1 <= len(entry) <= 3:
        raise TypeError(f"Invalid parameter tuple length {where}; expecting length between 1 and 3")
    name, value, descriptor = [*entry, None, None][:3]
    if not isinstance(name, str):
        raise TypeError(f"Expected string as name {where}")
    if namespace:
        name = f"{namespace}{PARAMETER_SEPARATOR_STRING}{name}"
    if descriptor is None:
        descriptor = rcl_msg.ParameterDescriptor()
    if not isinstance(descriptor, rcl_msg.ParameterDescriptor):
        raise TypeError(f"Expected a ParameterDescriptor as third item {where}")
    if len(entry) == 1:
        _warn_of_name_alone(name)
        descriptor.dynamic_typing = True
    return Declaration(name, _settle_type(name, value, descriptor), descriptor)


def _settle_type(name: str, value: Any, descriptor: rcl_msg.ParameterDescriptor) -> Any:
    """Write the type into the descriptor, and return the default."""
    if isinstance(value, ParameterType):
        if value is ParameterType.NOT_SET:
            raise ValueError(f"Cannot declare parameter {{{name}}} as statically typed of type NOT_SET")
        if descriptor.dynamic_typing:
            raise ValueError(
                f"When declaring parameter {{{name}}} passing a descriptor with`dynamic_typing=True` "
                "is not allowed when the parameter type is provided"
            )
        descriptor.type = value.value
        return None
    if isinstance(value, rcl_msg.ParameterValue):
        value = parameter_value_to_python(value)
    if value is None and not descriptor.dynamic_typing:
        raise ValueError(
            "Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET"
        )
    descriptor.type = Parameter(name, value=value).type_.value
    return value


def _warn_of_name_alone(name: str) -> None:
    warnings.warn(
        f"when declaring parameter named '{name}', declaring a parameter only providing its name is deprecated. "
        "You have to either:\n"
        '\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).\n'
        "\t- Pass a name and a parameter type.\n"
        "\t- Pass a name and a descriptor with `dynamic_typing=True",
        stacklevel=5,
    )
