"""What a page needs to make the form of a type: its fields, their defaults, bounds and choices, as values for JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.rosidl.class_search import find_field_class
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.sources import find_message
from tfloom.rosidl.spec import FLOATS, INTEGER_RANGES, STRINGS
from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.page_command import PageError

if TYPE_CHECKING:
    from tfloom.rosidl.message import Message
    from tfloom.rosidl.spec import Constant, Type

__all__ = ["TIME_TYPE", "type_form"]

TIME_TYPE = "builtin_interfaces/msg/Time"
MAX_FIELDS = 2000
"""Number of fields of all types of a form."""
MAX_SHOWN_ELEMENTS = 100
"""Length of an array whose elements are in the form; a longer one is empty there, which leaves its default."""
MAX_TEXT = 2000


def type_form(message_class: type[Message]) -> dict[str, Any]:
    """Return the form of a message: the name of its type, and the fields of each type that is in it.

    Each type is there once, so that types in types don't multiply. Numbers are texts, because those of 64 bits and
    those that are not finite are none of JSON's.

    Raises:
        PageError: there are too many fields.
        LookupError, ValueError: a definition is missing, or can't be parsed.
    """
    root = message_class._TYPE_NAME
    classes: dict[str, type[Message]] = {root: message_class}
    types: dict[str, list[dict[str, Any]]] = {}
    waiting = [root]
    field_count = 0
    while waiting:
        name = waiting.pop()
        current = classes[name]
        field_count += len(current._FIELDS)
        if field_count > MAX_FIELDS:
            raise PageError(f"{root} has more than {MAX_FIELDS} fields, too many for a form")
        constants = find_message(name).constants
        new = current()
        types[name] = [
            _field(field, parse_type(text), getattr(new, field), constants)
            for field, text in current._FIELDS.items()
        ]
        for text in current._FIELDS.values():
            base = parse_type(text)
            if not base.is_primitive and base.base not in classes and base.base != TIME_TYPE:
                classes[base.base] = find_field_class(base.base)
                waiting.append(base.base)
    return {"root": root, "types": types}


def _field(name: str, type_: Type, default: Any, constants: tuple[Constant, ...]) -> dict[str, Any]:
    least, greatest = INTEGER_RANGES.get(type_.base, (0, 0))
    is_integer = type_.base in INTEGER_RANGES
    return {
        "name": name,
        "type": str(type_),
        "kind": _kind(type_.base),
        "base": type_.base,
        "shape": type_.shape,
        "length": type_.length,
        "bound": type_.string_bound,
        "min": str(least) if is_integer else "",
        "max": str(greatest) if is_integer else "",
        "value": _default(type_, default),
        # A definition doesn't say which field its constants are for: they are offered for those of their type.
        "choices": [
            [constant.name, _text(constant.value)]
            for constant in constants
            if type_.is_primitive and constant.type.base == type_.base
        ],
    }


def _kind(base: str) -> str:
    if base in INTEGER_RANGES:
        return "integer"
    if base in FLOATS:
        return "float"
    if base in STRINGS:
        return "text"
    if base == "bool":
        return "bool"
    return "time" if base == TIME_TYPE else "message"


def _default(type_: Type, value: Any) -> str | list[str] | None:
    if not type_.is_primitive:
        return None
    if not type_.shape:
        return _text(value)
    return [_text(part) for part in value] if len(value) <= MAX_SHOWN_ELEMENTS else []


def _text(value: Any) -> str:
    if isinstance(value, bytes):
        return str(value[0])
    if isinstance(value, bool):
        return "true" if value else "false"
    return shown_text(str(value), MAX_TEXT)
