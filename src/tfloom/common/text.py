"""Values and times in the texts of errors and in output, and values of which it is known how they were written."""

from __future__ import annotations

import reprlib
from typing import Any, NamedTuple

__all__ = ["PlainValue", "QuotedText", "describe_machine_clock", "given_text", "shortened", "utc_text"]


MAX_VALUE = 200
"""Length of the part of a value that an error shows [characters]."""


def given_text(value: object) -> str:
    """Return a value, cut where it is long, and its class, as `'1' of class str`."""
    return f"{reprlib.repr(value)} of class {type(value).__name__}"


def shortened(value: object) -> str:
    """Return the text of a value, cut where it is long, as a whole file given for a parameter is."""
    text = str(value)
    return text if len(text) <= MAX_VALUE else f"{text[:MAX_VALUE]}…"


def utc_text(stamp_s: float) -> str:
    """Return a time as date and clock in UTC, and as a number where no date is so late."""
    from datetime import datetime, timezone

    try:
        return datetime.fromtimestamp(stamp_s, timezone.utc).strftime("%Y-%m-%d %H:%M:%S UTC")
    except (OverflowError, ValueError, OSError):
        return f"{stamp_s} s"


def describe_machine_clock(time_ns: int) -> str:
    """Return a clause that names the machine's clock and its value, a time in UTC.

    Args:
        time_ns: What the clock says [ns since the epoch].
    """
    from datetime import datetime, timedelta, timezone

    utc = datetime(1970, 1, 1, tzinfo=timezone.utc) + timedelta(seconds=time_ns // 1_000_000_000)
    return f"the machine's clock says {utc:%Y-%m-%d %H:%M:%S} UTC ({time_ns / 1e9:.0f} s since 1970)"


class QuotedText(str):
    """A text that is in quotes in YAML, so it is one whatever ROS's rules read in a plain one."""

    __slots__ = ()


class PlainValue(NamedTuple):
    """A value without quotes that YAML takes for no text, as `off`: a field of a message may be one."""

    text: str
    """As it is written."""
    value: Any
    """By YAML's rules."""
