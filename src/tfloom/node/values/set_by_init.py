"""Attributes of a node before its `__init__` has run."""

from __future__ import annotations

from typing import Any, NoReturn

__all__ = ["SET_BY_INIT"]


class _SetByInit:
    """Placeholder for an attribute that `__init__` sets; the instance's own value hides it."""

    def __get__(self, instance: object, owner: type | None = None) -> NoReturn:
        name = type(instance).__name__
        # Python fills in the attribute's name where `name` and `obj` are not given, and would then suggest one of
        # the placeholders, which are no names for users.
        raise AttributeError(
            f"this {name} is no node yet: {name}.__init__ has to call super().__init__('a_node_name') "
            "before it uses anything of a node",
            name=None,
            obj=instance,
        )


SET_BY_INIT: Any = _SetByInit()
"""Value in a class for what its `__init__` sets: reading it before raises an AttributeError that names the call."""
