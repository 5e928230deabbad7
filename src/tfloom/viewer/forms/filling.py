"""From what a page filled in to a message. It is text from outside, so what it may make is bounded."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.rosidl import cdr
from tfloom.rosidl.class_search import find_field_class
from tfloom.rosidl.fill import Filler
from tfloom.rosidl.parse import parse_type
from tfloom.viewer.page_command import PageError

if TYPE_CHECKING:
    from tfloom.rosidl.message import Message

__all__ = ["fill", "stamp_of_ns"]

MAX_VALUES = 200_000
"""Number of values of a message: a page's short text may ask for many messages in messages, with arrays in them."""


def fill(message: Message, values: Any, now_ns: int) -> bytes:
    """Set a message's fields from values of JSON; return its bytes.

    A time may be the word `now`, and a header the word `auto`.

    Args:
        message: The message.
        values: Field names to values, nested as the message is. A text stands for a number, too.
        now_ns: The time of now [ns since epoch].

    Raises:
        PageError: there is no such field, a value doesn't fit it, or there are too many; the text names the field.
    """
    if _count(message._TYPE_NAME) + _added(message._TYPE_NAME, values) > MAX_VALUES:
        raise PageError(f"a message from a form has at most {MAX_VALUES} values")
    filler = Filler(auto=True, now=True, numbers_are_texts=True)
    try:
        filler.fill(message, values)
        for set_stamp in filler.setters:
            set_stamp(stamp_of_ns(now_ns))
        return cdr.encode(message)
    except (AttributeError, TypeError, ValueError, AssertionError, OverflowError) as error:
        path = "".join(filler.path).lstrip(".")
        raise PageError(f"{path}: {error}" if path else str(error)) from None


def stamp_of_ns(stamp_ns: int) -> Time:
    """Return a time [ns since epoch] as a message."""
    sec, nanosec = divmod(stamp_ns, 1_000_000_000)
    return Time(sec=sec, nanosec=nanosec)


@lru_cache(maxsize=1000)
def _count(type_name: str) -> int:
    """Return how many values a new message holds."""
    total = 0
    for text in find_field_class(type_name)._FIELDS.values():
        type_ = parse_type(text)
        if type_.shape in {"", "array"}:
            each = 1 if type_.is_primitive else _count(type_.base)
            total += each * (type_.length if type_.shape else 1)
    return total


def _added(type_name: str, values: Any) -> int:
    """Return how many values the messages hold that values add to sequences and arrays."""
    if not isinstance(values, Mapping):
        return 0
    fields = find_field_class(type_name)._FIELDS
    total = 0
    for name, value in values.items():
        type_ = parse_type(fields[name]) if name in fields else None
        if type_ is None or type_.is_primitive:
            continue  # an unknown name is an error later, and a primitive's elements are in the page's text
        if type_.shape and isinstance(value, list):
            total += sum(_count(type_.base) + _added(type_.base, element) for element in value)
        elif not type_.shape:
            total += _added(type_.base, value)
    return total
