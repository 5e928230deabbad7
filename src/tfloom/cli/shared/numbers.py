"""Types of numeric arguments, for argparse's errors about malformed numbers and numbers out of range."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable

FOREVER_S = 1e9
"""The longest duration, to which longer ones are reduced [s]: 31 years."""
MOST = 2**31 - 1
INT64_END = 2**63


def seconds(text: str) -> float:
    """Return a duration that isn't negative [s].

    Raises:
        argparse.ArgumentTypeError: it is not a number, or negative.
    """
    what = "a number of seconds that isn't negative"
    return min(_number(text, lambda value: value >= 0.0, what), FOREVER_S)


def tolerance(text: str) -> float:
    """Return a threshold, as a distance or an angle, that isn't negative.

    Raises:
        argparse.ArgumentTypeError: it is not a number, or negative.
    """
    return _number(text, lambda value: value >= 0.0, "a number that isn't negative")


def positive(text: str) -> float:
    """Return a number above 0.

    Raises:
        argparse.ArgumentTypeError: it is not a number, not above 0, or not finite.
    """
    return _number(text, lambda value: 0.0 < value < math.inf, "a number greater than zero")


def rate(text: str) -> float:
    """Return a rate [Hz]; the verb itself rejects one that isn't above zero, in the reference's words.

    Raises:
        argparse.ArgumentTypeError: it is not a number.
    """
    value = _number(text, lambda value: not math.isnan(value), "a number")
    return max(value, 1 / FOREVER_S) if value > 0 else value


def count(text: str) -> int:
    """Return a whole number, 0 or more.

    Raises:
        argparse.ArgumentTypeError: it is not a number, negative, or beyond 32 bits.
    """
    return _whole_number(text, 0)


def size(text: str) -> int:
    """Return a number of bytes, or another whole number, 0 or more.

    Raises:
        argparse.ArgumentTypeError: it is not a number, negative, or beyond 63 bits.
    """
    return _whole_number(text, 0, INT64_END - 1)


def positive_count(text: str) -> int:
    """Return a whole number, 1 or more.

    Raises:
        argparse.ArgumentTypeError: as `count`, or it is 0.
    """
    return _whole_number(text, 1)


def finite(text: str) -> float:
    """Return a number, which may be negative.

    Raises:
        argparse.ArgumentTypeError: it is not a number, or not finite.
    """
    return _number(text, math.isfinite, "a number")


def whole(text: str) -> int:
    """Return a whole number of 64 bits, which may be negative.

    Raises:
        argparse.ArgumentTypeError: it is none.
    """
    try:
        value = int(text)
    except ValueError:
        value = INT64_END
    if not -INT64_END <= value < INT64_END:
        raise argparse.ArgumentTypeError(f"must be a whole number, not {text!r}")
    return value


def unsigned(text: str) -> int:
    """Return a whole number of 64 bits that isn't negative.

    Raises:
        argparse.ArgumentTypeError: it is none.
    """
    return _whole_number(text, 0, 2 * INT64_END - 1)


def _number(text: str, is_valid: Callable[[float], bool], what: str) -> float:
    """Return a number; raise the error that it must be `what` if it isn't valid, as nan is not."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not is_valid(value):
        raise argparse.ArgumentTypeError(f"must be {what}, not {text!r}")
    return value


def _whole_number(text: str, least: int, most: int = MOST) -> int:
    try:
        value = int(text)
    except ValueError:
        value = -1
    if not least <= value <= most:
        raise argparse.ArgumentTypeError(f"must be a whole number from {least} to {most}, not {text!r}")
    return value
