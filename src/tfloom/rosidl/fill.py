"""Filling of messages from plain values, such as YAML on a command line."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from tfloom.rosidl.message import Message
from tfloom.rosidl.parse import parse_type
from tfloom.rosidl.registry import get_message_class
from tfloom.rosidl.spec import FLOATS, INTEGER_RANGES, STRINGS, Type
from tfloom.rosidl.type_text import ARRAY_CODES

StampSetter = Callable[[Message], None]
"""A function that sets a `builtin_interfaces/msg/Time` in a field whose value was `now` or `auto`."""


def set_message_fields(
    msg: Message, values: Any, expand_header_auto: bool = False, expand_time_now: bool = False
) -> list[StampSetter]:
    """Set fields of a message from a mapping, nested as the message is.

    Args:
        msg: The message to change. Fields that are not in `values` stay unchanged.
        values: Field names to plain values, which are converted to the field's type if that is exact: 1 to 1.0,
            '5' to 5. None leaves `msg` unchanged.
        expand_header_auto: Whether a `std_msgs/msg/Header` may be the word `auto`: its stamp is set later.
        expand_time_now: Whether a `builtin_interfaces/msg/Time` may be the word `now`: it is set later.

    Returns:
        A function for each time that is set later, to be called with the time of publishing.

    Raises:
        AttributeError: there is no such field.
        TypeError, ValueError: a value doesn't fit its field.
    """
    filler = Filler(auto=expand_header_auto, now=expand_time_now)
    filler.fill(msg, {} if values is None else values)
    return filler.setters


class Filler:
    """Fills a message as `set_message_fields` does, and keeps the path of a field that a value did not fit."""

    def __init__(self, *, auto: bool, now: bool, numbers_are_texts: bool = False) -> None:
        self._numbers_are_texts = numbers_are_texts
        """Whether the text `7` is the byte 7, and not that of the character, as `message_to_yaml` writes it."""
        self.setters: list[StampSetter] = []
        self.path: list[str] = []
        """The path of the field that is being set, or that raised an error: `.poses`, `[1]`, `.header`."""
        self.words = {"std_msgs/msg/Header": "auto"} if auto else {}
        if now:
            self.words["builtin_interfaces/msg/Time"] = "now"

    def fill(self, msg: Message, values: Any) -> None:
        """Set fields of a message from a mapping; see `set_message_fields`."""
        if not isinstance(values, Mapping):
            kind = type(values).__name__
            raise TypeError(f"Value '{values}' is expected to be a dictionary but is a {kind}")
        fields = getattr(msg, "_FIELDS", None)
        for name, value in values.items():
            if fields is None:
                self._set_unknown(msg, name, value)
                continue
            if name not in fields:
                text = f"'{type(msg).__name__}' object has no attribute '{name}'"
                raise AttributeError(text, name=name, obj=msg)
            self.path.append(f".{name}")
            self._set(msg, name, parse_type(fields[name]), value)
            self.path.pop()

    def _set_unknown(self, msg: Any, name: str, value: Any) -> None:
        """Set an attribute of an object that is used as a message but isn't one, by the type of what it holds."""
        current = getattr(msg, name)
        self.path.append(f".{name}")
        if isinstance(value, str) and value == self.words.get(getattr(current, "_TYPE_NAME", "")):
            self._set_later(msg, name, value)
        elif isinstance(value, Mapping) and not isinstance(current, Mapping):
            self.fill(current, value)
        elif current is None or isinstance(value, type(current)):
            setattr(msg, name, value)
        else:
            setattr(msg, name, type(current)(value))
        self.path.pop()

    def _set_later(self, msg: Any, name: str, word: str) -> None:
        is_time = word == "now"
        self.setters.append(
            partial(setattr, msg if is_time else getattr(msg, name), name if is_time else "stamp")
        )

    def _set(self, msg: Message, name: str, type_: Type, value: Any) -> None:
        if isinstance(value, str) and value == self.words.get(type_.base) and not type_.shape:
            self._set_later(msg, name, value)
        elif type_.shape:
            setattr(msg, name, self._array(type_, value))
        elif type_.is_primitive:
            setattr(msg, name, self._primitive(type_, value))
        elif isinstance(value, Message):
            setattr(msg, name, value)
        else:
            self.fill(getattr(msg, name), value)

    def _primitive(self, type_: Type, value: Any) -> Any:
        is_byte = type_.base == "byte" and not self._numbers_are_texts
        if is_byte and isinstance(value, str) and len(value) == 1 and ord(value) < 256:
            return value.encode("latin-1")
        return _convert(type_, value)

    def _array(self, type_: Type, values: Any) -> Any:
        if isinstance(values, (str, Mapping)) or not hasattr(values, "__iter__"):
            raise TypeError(f"Value '{values}' is expected to be a list but is a {type(values).__name__}")
        if isinstance(values, (bytes, bytearray)) or hasattr(values, "typecode") or hasattr(values, "dtype"):
            return values if type_.base in ARRAY_CODES else [_convert(type_.element, item) for item in values]
        return [self._element(type_.element, index, item) for index, item in enumerate(values)]

    def _element(self, type_: Type, index: int, value: Any) -> Any:
        self.path.append(f"[{index}]")
        if type_.is_primitive:
            element = self._primitive(type_, value)
        elif isinstance(value, Message):
            element = value
        else:
            element = get_message_class(type_.base)()
            self.fill(element, value)
        self.path.pop()
        return element


def _convert(type_: Type, value: Any) -> Any:
    """Convert a plain value if that is exact."""
    if type_.base in FLOATS:
        return float(value)
    if type_.base in STRINGS:
        return str(value)
    if type_.base == "bool":
        return _to_bool(value)
    if type_.base == "byte" and isinstance(value, bytes):
        return value
    number = int(value)
    if isinstance(value, float) and number != value:
        raise ValueError(f"{value} is not a whole number, and the field's type is {type_}")
    least, greatest = INTEGER_RANGES[type_.base]
    if not least <= number <= greatest:
        raise ValueError(f"{number} is outside {type_}'s range [{least}, {greatest}]")
    return bytes([number]) if type_.base == "byte" else number


def _to_bool(value: Any) -> bool:
    if value in (0, 1):
        return bool(value)
    if isinstance(value, str) and value.lower() in {"true", "false"}:
        return value.lower() == "true"
    raise ValueError(f"'{value}' is neither true nor false")
