"""The check of an argument's type, and whether an object or a class is of a kind."""

from __future__ import annotations

import types
from collections.abc import Iterable
from typing import Any

from tfloom.ros_imports.guard import ros_class_repr

__all__ = ["ensure_argument_type", "is_a", "is_a_subclass", "isclassinstance"]
ROUTINES = (
    types.FunctionType,
    types.MethodType,
    types.BuiltinFunctionType,
    types.MethodDescriptorType,
    types.WrapperDescriptorType,
)


def ensure_argument_type(
    argument: Any, types: type | Iterable[type], argument_name: str, caller: str | None = None
) -> None:
    """Raise TypeError unless an argument is of one of the types.

    Args:
        argument: The argument's value.
        types: A class or several; an instance and a class derived from it are accepted.
        argument_name: Its name, for the error.
        caller: The function's name, for the error.

    Raises:
        TypeError: the argument is of another type.
    """
    allowed = tuple(types) if isinstance(types, Iterable) else (types,)
    for kind in allowed:
        origin = getattr(kind, "__origin__", kind)
        if not isinstance(origin, type):
            raise TypeError(f"'{kind!r}' in 'types' is not a type")
        if isinstance(argument, origin) or (isinstance(argument, type) and issubclass(argument, origin)):
            return
    named = ", ".join(ros_class_repr(kind) if isinstance(kind, type) else repr(kind) for kind in allowed)
    start = f"'{caller}' expected" if caller else "Expected"
    raise TypeError(
        f"{start} '{argument_name}' to be one of [{named}], but got '{argument}' of type "
        f"'{ros_class_repr(type(argument))}'"
    )


def isclassinstance(obj: Any) -> bool:
    """Return whether an object is an instance, and neither a class, a function nor a module."""
    return not isinstance(obj, (type, types.ModuleType, *ROUTINES))


def is_a(obj: Any, entity_type: type) -> bool:
    """Return whether an object is an instance of exactly a class, or has it among its bases."""
    return isclassinstance(obj) and isinstance(obj, entity_type)


def is_a_subclass(obj: Any, entity_type: type) -> bool:
    """Return whether a class, or an instance's class, is a class or derived from it."""
    if isinstance(obj, type):
        return issubclass(obj, entity_type)
    return is_a(obj, entity_type)
