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
    value_error,
)
from tfloom.ros_imports import ros_distro

__all__ = ["Declaration", "declaration_error", "full_name", "read_declarations", "warn_of_names_alone"]


class Declaration(NamedTuple):
    """A parameter to declare."""

    name: str
    default: Any
    """None: it has no default."""
    descriptor: rcl_msg.ParameterDescriptor


def read_declarations(namespace: str, parameters: Sequence[tuple[Any, ...]]) -> list[Declaration]:
    """Return the declarations in tuples of (name), (name, value or type) or (name, value or type, descriptor).

    Raises:
        TypeError: a tuple isn't of that form; from Lyrical on also that it has only a name.
        ValueError: a type is NOT_SET, or given together with dynamic typing; or there is neither value nor type,
            and no dynamic typing.
    """
    if (error := declaration_error(namespace, parameters)) is not None:
        raise error
    return [_read_declaration(namespace, entry) for entry in parameters]


def declaration_error(namespace: str, parameters: Sequence[tuple[Any, ...]]) -> Exception | None:
    """Return what `read_declarations` raises, or None, for callers whose tracebacks shall be short."""
    for index, entry in enumerate(parameters):
        error: Exception | None = _form_error(index, entry)
        if error is None:
            name, value, descriptor = [*entry, None, None][:3]
            name = full_name(namespace, name)
            is_dynamic = len(entry) == 1 or (descriptor is not None and descriptor.dynamic_typing)
            is_refused = len(entry) == 1 and ros_distro.NEEDS_MORE_THAN_A_NAME
            refusal = TypeError(_name_alone(name, "not allowed")) if is_refused else None
            error = refusal or _type_error(name, value, is_dynamic=is_dynamic)
        if error is not None:
            return error
    return None


def _form_error(index: int, entry: Any) -> TypeError | None:
    where = f"at index {index} in parameters list: {entry}"
    if not isinstance(entry, (tuple, list)):
        return TypeError(f"Expected a tuple of a name, and a value or a type, {where}: write ('speed', 1.0)")
    if not 1 <= len(entry) <= 3:
        return TypeError(f"Invalid parameter tuple length {where}; expecting length between 1 and 3")
    name, _, descriptor = [*entry, None, None][:3]
    if not isinstance(name, str):
        return TypeError(f"Expected string as name {where}")
    if descriptor is not None and not isinstance(descriptor, rcl_msg.ParameterDescriptor):
        return TypeError(f"Expected a ParameterDescriptor as third item {where}")
    return None


def full_name(namespace: str, name: str) -> str:
    """Return a parameter's name below a namespace; "" is none."""
    return f"{namespace}{PARAMETER_SEPARATOR_STRING}{name}" if namespace else name


def warn_of_names_alone(
    namespace: str, parameters: Sequence[tuple[Any, ...]], error: Exception | None
) -> None:
    """Warn of tuples that have only a name, at the line that called the caller.

    Args:
        namespace: Of the names.
        parameters: The tuples.
        error: What their declaration will raise. Of tuples that are not of their form nothing else is said.
    """
    if isinstance(error, (TypeError, ValueError)):
        return
    for entry in parameters:
        if len(entry) == 1:
            warnings.warn(_name_alone(full_name(namespace, entry[0]), "deprecated"), stacklevel=3)


def _name_alone(name: str, is_what: str) -> str:
    return (
        f"when declaring parameter named '{name}', declaring a parameter only providing its name is "
        f"{is_what}. You have to either:\n"
        '\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).\n'
        "\t- Pass a name and a parameter type.\n"
        "\t- Pass a name and a descriptor with `dynamic_typing=True"
    )


def _read_declaration(namespace: str, entry: tuple[Any, ...]) -> Declaration:
    name, value, descriptor = [*entry, None, None][:3]
    name = full_name(namespace, name)
    if descriptor is None:
        descriptor = rcl_msg.ParameterDescriptor()
    if len(entry) == 1:
        descriptor.dynamic_typing = True
    return Declaration(name, _settle_type(name, value, descriptor), descriptor)


def _type_error(name: str, value: Any, *, is_dynamic: bool) -> Exception | None:
    if isinstance(value, ParameterType):
        if value is ParameterType.NOT_SET:
            return ValueError(f"Cannot declare parameter {{{name}}} as statically typed of type NOT_SET")
        if is_dynamic:
            return ValueError(
                f"When declaring parameter {{{name}}} passing a descriptor with`dynamic_typing=True` "
                "is not allowed when the parameter type is provided"
            )
        return None
    if isinstance(value, rcl_msg.ParameterValue):
        value = parameter_value_to_python(value)
    if value is None and not is_dynamic:
        return ValueError(
            "Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET"
        )
    return value_error(value)


def _settle_type(name: str, value: Any, descriptor: rcl_msg.ParameterDescriptor) -> Any:
    """Write the type into the descriptor, and return the default."""
    if isinstance(value, ParameterType):
        descriptor.type = value.value
        return None
    if isinstance(value, rcl_msg.ParameterValue):
        value = parameter_value_to_python(value)
    descriptor.type = Parameter(name, value=value).type_.value
    return value
