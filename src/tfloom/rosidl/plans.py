"""Compilation of message classes to the plans of the native codec."""

from __future__ import annotations

import threading

from tfloom._native import MessageBase, Plan, complete_plan
from tfloom.rosidl.class_search import find_field_class
from tfloom.rosidl.type_text import ARRAY_CODES, NUMPY_NAMES, split_type

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from tfloom.rosidl.class_table import MessageClass

_ZEROS: dict[str, Any] = {
    **dict.fromkeys(ARRAY_CODES, 0),
    "float32": 0.0,
    "float64": 0.0,
    "bool": False,
    "byte": b"\0",
    "string": "",
    "wstring": "",
}

_compiling: list[type[MessageClass]] = []
_lock = threading.RLock()  # because a plan that others refer to must not be replaced by a second one


def compile_plan(cls: type[MessageClass]) -> Plan:
    """Compile the plan of a message class, and of the messages in it, and store it on the class.

    Raises:
        TypeError: the class is not a message class, or it contains itself.
        LookupError: it refers to an unknown message.
    """
    owner = _owner(cls)
    with _lock:
        return owner._PLAN or _compile(owner)


def _owner(cls: type[MessageClass]) -> type[MessageClass]:
    """Return the class itself, or the base that has the fields."""
    if issubclass(cls, MessageBase):
        for base in cls.__mro__:
            if base.__dict__.get("_TYPE_NAME"):
                return base
    raise TypeError(f"{cls.__qualname__} is not a message class")


def _compile(owner: type[MessageClass]) -> Plan:
    if owner in _compiling:
        raise TypeError(f"{owner._TYPE_NAME} contains itself")
    plan = Plan(owner, owner._TYPE_NAME)
    _compiling.append(owner)
    try:
        _add_fields(plan, owner)
    finally:
        _compiling.remove(owner)
    complete_plan(plan)
    owner._PLAN = plan
    return plan


def _add_fields(plan: Plan, owner: type[MessageClass]) -> None:
    for name, text in owner._FIELDS.items():
        _add_field(plan, name, text, owner._DEFAULTS.get(name))


def _add_field(plan: Plan, name: str, type_text: str, default: Any) -> None:
    base, string_bound, shape, length = split_type(type_text)
    nested = None
    if base not in _ZEROS:
        nested = find_field_class(base)
        if nested._PLAN is None:
            compile_plan(nested)
    is_array = bool(shape) and base in ARRAY_CODES
    if is_array:
        initial = empty = _empty(base, length if shape == "array" else 0)
        if default is not None:
            initial = _filled(type_text, default)
    else:
        initial, empty = _initial(base, shape, length, default), None
    plan.add_field(
        name=name,
        kind="message" if nested else base,
        shape=shape,
        count=length,
        string_bound=string_bound,
        message_class=nested,
        initial=initial,
        copies=isinstance(initial, list) or is_array,
        empty=empty,
    )


def _empty(base: str, length: int) -> Any:
    """Return the initial value of a numeric array: zeros if its length is fixed, else an array of length 0."""
    if length:
        import numpy as np

        return np.zeros(length, NUMPY_NAMES[base])
    from array import array

    return array(ARRAY_CODES[base])


def _filled(type_text: str, default: Any) -> Any:
    from tfloom.rosidl.arrays import convert

    return convert(type_text, default)


def _initial(base: str, shape: str, length: int, default: Any) -> Any:
    """Return the default of a field other than a numeric array; None for a message, which is built anew each time."""
    zero = _ZEROS.get(base)
    if shape:
        return list(default or ([zero] * length if shape == "array" and base in _ZEROS else []))
    return zero if default is None else default
