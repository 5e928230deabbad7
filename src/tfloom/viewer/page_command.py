"""What a page asks for, checked, because it is text from outside; and errors as sentences for a page."""

from __future__ import annotations

import contextlib
import math
import traceback
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tfloom.rmw.errors import WireError
from tfloom.rosidl.message import DecodeError
from tfloom.tf2.errors import TransformException
from tfloom.viewer.shapes import DisplayError

__all__ = ["PageError", "fault_text", "flag", "number", "stamp", "text", "texts", "whole"]

MAX_TEXT = 4096
"""Number of characters of a text that a page may send."""
MAX_TEXTS = 20
"""Number of texts in a list that a page may send."""


class PageError(Exception):
    """A page asks for what can't be done; the text says why, in one sentence for the page."""


def text(command: Mapping[str, Any], name: str) -> str:
    """Return a text of a command.

    Raises:
        PageError: it is absent, not a text, too long, or has halves of surrogate pairs, which no name can have.
    """
    value = command.get(name)
    if not isinstance(value, str) or len(value) > MAX_TEXT:
        raise PageError(f"{name} has to be a text of at most {MAX_TEXT} characters")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise PageError(f"{name} has to be a text of Unicode, without halves of surrogate pairs") from None
    return value


def texts(command: Mapping[str, Any], name: str) -> list[str]:
    """Return a list of texts of a command.

    Raises:
        PageError: it is absent, no list of texts, or one is too long, or there are too many.
    """
    values = command.get(name)
    if not isinstance(values, list) or len(values) > MAX_TEXTS:
        raise PageError(f"{name} has to be a list of at most {MAX_TEXTS} texts")
    return [text({name: value}, name) for value in values]


def number(command: Mapping[str, Any], name: str) -> float:
    """Return a finite number of a command.

    Raises:
        PageError: it is absent, not a number, or not finite.
    """
    value = command.get(name)
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        # An integer of JSON may have hundreds of digits, more than a float holds.
        with contextlib.suppress(OverflowError):
            if math.isfinite(value):
                return float(value)
    raise PageError(f"{name} has to be a finite number")


def whole(command: Mapping[str, Any], name: str) -> int:
    """Return a whole number of a command.

    Raises:
        PageError: it is absent, or none.
    """
    value = number(command, name)
    if not value.is_integer():
        raise PageError(f"{name} has to be a whole number")
    return int(value)


def flag(command: Mapping[str, Any], name: str) -> bool:
    """Return a truth value of a command.

    Raises:
        PageError: it is absent, or none.
    """
    value = command.get(name)
    if not isinstance(value, bool):
        raise PageError(f"{name} has to be true or false")
    return value


def stamp(command: Mapping[str, Any], name: str) -> int | None:
    """Return a time [ns since epoch], which a page sends as a text of digits, because its numbers end at 2**53.

    Raises:
        PageError: it is neither null nor digits.
    """
    value = command.get(name)
    if value is None:
        return None
    if not isinstance(value, str) or not value.isascii() or not value.isdigit() or len(value) > 19:
        raise PageError(f"{name} has to be null, or digits")
    return int(value)


def fault_text(error: Exception) -> str:
    """Return an error's text; of one that nobody thought of, also its type and where it was raised."""
    if isinstance(error, (PageError, DisplayError, DecodeError, WireError, TransformException)):
        return str(error).rstrip()
    said = f"{type(error).__name__}: {error}"
    if frames := traceback.extract_tb(error.__traceback__):
        said += f" ({Path(frames[-1].filename).name}, line {frames[-1].lineno})"
    return said
