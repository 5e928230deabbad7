"""From a message class to the plan that the native codec walks."""

from __future__ import annotations

from array import array
from typing import Any

from tfloom._native import Plan
from tfloom.rosidl.arrays import numeric_array
from tfloom.rosidl.message import ARRAY_CODES, Message
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.registry import get_message_class
from tfloom.rosidl.spec import Type

_ZEROS: dict[str, Any] = {"bool": False, "byte": b"\0", "string": "", "wstring": ""}


def compile_plan(cls: type[Message]) -> Plan:
    """Compile the plan of a message class, and of the messages in it, and leave it on the class.

    Raises:
        TypeError: the class is no message class.
        LookupError: it refers to a message that is not known.
    """
    owner = next(
        (base for base in cls.__mro__ if issubclass(base, Message) and "_FIELDS" in base.__dict__), Message
    )
    if owner is Message:
        raise TypeError(f"{cls.__qualname__} is no message class")
    if owner._PLAN is None:
        plan = Plan(owner, owner._TYPE_NAME)
        for name, text in owner._FIELDS.items():
            _add_field(plan, name, parse_type(text), owner._DEFAULTS.get(name))
        owner._PLAN = plan
        return plan
    return owner._PLAN


def _add_field(plan: Plan, name: str, type_: Type, default: Any) -> None:
    nested = None
    if not type_.is_primitive:
        nested = get_message_class(type_.base)
        if nested._PLAN is None:
            compile_plan(nested)
    is_array = bool(type_.shape) and type_.base in ARRAY_CODES
    initial = _initial(type_, default)
    plan.add_field(
        name=name,
        kind="message" if nested else type_.base,
        shape=type_.shape,
        count=type_.length,
        string_bound=type_.string_bound,
        message_class=nested,
        initial=initial,
        copies=isinstance(initial, list) or is_array,
        empty=_empty(type_) if is_array else None,
    )


def _empty(type_: Type) -> Any:
    """Return a numeric array without content: of length 0, or of zeros if its length is fixed."""
    return numeric_array(type_, type_.length) if type_.shape == "array" else array(ARRAY_CODES[type_.base])


def _initial(type_: Type, default: Any) -> Any:
    """Return the default of a field; None for messages, which are built anew."""
    if type_.shape and type_.base in ARRAY_CODES:
        initial = _empty(type_)
        if default is not None:
            initial = (
                numeric_array(type_, default) if type_.shape == "array" else array(initial.typecode, default)
            )
        return initial
    if type_.shape:
        if default is not None:
            return list(default)
        return [_zero(type_)] * type_.length if type_.shape == "array" and type_.is_primitive else []
    return _zero(type_) if default is None else default


def _zero(type_: Type) -> Any:
    if not type_.is_primitive:
        return None
    return _ZEROS.get(type_.base, 0.0 if type_.base.startswith("float") else 0)
