"""Seconds that programs give: their nanoseconds, and what is said of a period or a timeout that is not a number."""

from __future__ import annotations

import math
from typing import Any

from tfloom.common.text import given_text

__all__ = [
    "MAX_S",
    "checked_timeout",
    "duration_error",
    "given_time",
    "no_time_of",
    "not_a_number",
    "plain_value",
    "timeout_error",
    "to_nanoseconds",
    "too_long",
]

_S_TO_NS = 1_000_000_000
MAX_S = (2**63 - 1) / _S_TO_NS
"""As many seconds as 64 bits of nanoseconds hold."""


def not_a_number(what: str, given: object) -> str:
    """Return what is needed, as `a period in seconds`, and what a program gave."""
    return f"needs {what}, as 0.5, got {given_text(given)}"


def too_long(what: str, given: object) -> str:
    """Return that 64 bits of nanoseconds don't hold what a program gave."""
    return f"needs a {what} of at most 292 years, got {given_text(given)}"


def no_time_of(name: str, seconds: object, nanoseconds: object) -> str:
    """Return which of the arguments of a Time or a Duration is not a number."""
    if not hasattr(seconds, "__float__"):
        return f"{name} {not_a_number('seconds', seconds)}"
    given = given_text(nanoseconds)
    return f"{name} needs nanoseconds, as 500, got {given}"


def given_time(given: object) -> str:
    """Return the end of an error's text: what was given in place of a time's or a duration's message."""
    has_message = hasattr(given, "to_msg") and not isinstance(given, type)
    hint = ", which is one of rclpy: use it as it is" if has_message else ""
    return f", got {given_text(given)}{hint}"


def duration_error(needed: str, given: object) -> TypeError:
    """Return the error of what was given in place of a Duration; `needed` begins its text."""
    seconds = given if isinstance(given, (int, float)) else "…"
    return TypeError(
        f"{needed}, got {given!r} of class {type(given).__name__}: write Duration(seconds={seconds})"
    )


def plain_value(value: Any) -> Any:
    """Return a number, text or array of numpy, or a list with such items, as Python has it; others unchanged."""
    if hasattr(value, "dtype"):
        return value.tolist()
    if isinstance(value, (list, tuple)) and any(hasattr(item, "dtype") for item in value):
        items = [plain_value(item) for item in value]
        return items if isinstance(value, list) else tuple(items)
    return value


def to_nanoseconds(seconds: float) -> int:
    """Return seconds, of any class of numbers, in whole nanoseconds, truncated.

    Raises:
        TypeError: it is not a number.
        ValueError: it is NaN, or a text.
        OverflowError: it is infinite.
    """
    # numpy multiplies within a number's own width, in which 5 s are 705,032,704 ns of int32, and infinite of float16.
    number: Any = seconds
    if getattr(number, "shape", None) == ():
        number = number.item()
    if isinstance(number, str):
        raise ValueError(not_a_number("seconds", number))  # noqa: TRY004, the reference's kind
    if not hasattr(number, "__float__"):  # a list, whose product would take all memory
        raise TypeError(not_a_number("seconds", number))
    return int(number * _S_TO_NS)


def timeout_error(call: str, timeout_sec: object) -> TypeError | ValueError | None:
    """Return the error of a timeout [s] that `call` got and that is neither None nor a number; None if it is one."""
    if timeout_sec is None:
        return None
    if not hasattr(timeout_sec, "__float__"):
        nanoseconds = getattr(timeout_sec, "nanoseconds", None)
        meant = f": write {nanoseconds / 1e9:g}" if isinstance(nanoseconds, int) else ""
        return TypeError(f"{call}() {not_a_number('a timeout in seconds', timeout_sec)}{meant}")
    if timeout_sec != timeout_sec:  # noqa: PLR0124  # NaN, of any class
        return ValueError(f"{call}() {not_a_number('a timeout in seconds', timeout_sec)}")
    return None


def checked_timeout(call: str, timeout_sec: float | None) -> float | None:
    """Return a timeout [s] that a program gave to `call`; None without a limit, and beyond 64 bits of nanoseconds.

    Raises:
        TypeError: it is not a number.
        ValueError: it is NaN.
    """
    if (error := timeout_error(call, timeout_sec)) is not None:
        raise error
    if timeout_sec is None:
        return None
    try:
        timeout_s = float(timeout_sec)
    except OverflowError:  # an int beyond the range of floats
        timeout_s = math.inf if timeout_sec > 0 else -math.inf
    # All negative ones mean the same.
    return None if timeout_s >= MAX_S else max(timeout_s, -1.0)
