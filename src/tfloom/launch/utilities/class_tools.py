"""Whether an object or a class is of a kind."""

from __future__ import annotations

import types
from typing import Any

__all__ = ["is_a", "is_a_subclass", "isclassinstance"]

ROUTINES = (
    types.FunctionType,
    types.MethodType,
    types.BuiltinFunctionType,
    types.MethodDescriptorType,
    types.WrapperDescriptorType,
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
