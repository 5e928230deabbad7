"""Filters of logger calls: once, skip the first, at most one in a period."""

from __future__ import annotations

import time
from types import CodeType
from typing import Any, NamedTuple

from tfloom.node.log.logging_severity import LoggingSeverity
from tfloom.node.values.constants import S_TO_NS
from tfloom.node.values.readable_clock import ReadableClock

__all__ = ["CallState", "CallerId", "make_state"]

_PARAMETERS = {
    "once": "once",
    "skip_first": "skip_first",
    "throttle_duration_sec": "throttle",
    "throttle_time_source_type": "throttle",
}


class CallerId(NamedTuple):
    """A place in a program that calls a logger."""

    code: CodeType
    line: int
    last_instruction: int

    @property
    def function_name(self) -> str:
        """Name of the function."""
        return self.code.co_name

    @property
    def file_path(self) -> str:
        """Path of the file that the function is in."""
        return self.code.co_filename


class CallState:
    """State of the filters of one place in a program, kept between calls."""

    __slots__ = ("_clock", "_first", "_last_ns", "_once", "_period_ns", "_skip_first", "severity")

    def __init__(
        self,
        severity: LoggingSeverity,
        once: bool,
        skip_first: bool,
        period_s: float | None,
        clock: ReadableClock | None,
    ) -> None:
        self.severity = severity
        self._once = once
        self._skip_first = skip_first
        self._period_ns = None if period_s is None else int(period_s * S_TO_NS)
        self._clock = clock
        self._first = True
        self._last_ns: int | None = None

    def lets_through(self) -> bool:
        """Return whether this call is to be logged, and count it."""
        first, self._first = self._first, False
        if self._once and not first:
            return False
        if self._skip_first and first:
            return False
        if self._period_ns is None:
            return True
        now_ns = time.monotonic_ns() if self._clock is None else self._clock.now().nanoseconds
        # After a jump backward of the clock, the period starts anew.
        if self._last_ns is not None and 0 <= now_ns - self._last_ns < self._period_ns:
            return False
        self._last_ns = now_ns
        return True


def make_state(severity: LoggingSeverity, options: dict[str, Any]) -> CallState:
    """Check the options of a logger call, and return the initial state of its filters.

    Raises:
        TypeError: an option is unknown, lacks an option that it requires, or has a value of the wrong type.
    """
    for name in options:
        if name not in _PARAMETERS:
            option_names = ", ".join(_PARAMETERS)
            raise TypeError(
                f'parameter "{name}" is not one of the recognized logging options "{option_names}"'
            )
    period_s = options.get("throttle_duration_sec")
    clock = options.get("throttle_time_source_type")
    if period_s is not None and not hasattr(period_s, "__float__"):
        raise TypeError(f"throttle_duration_sec must be a number of seconds, not {type(period_s).__name__}")
    if clock is not None and period_s is None:
        raise TypeError(
            'required parameter "throttle_duration_sec" not specified but is required for the the logging filter '
            '"throttle"'
        )
    if clock is not None and not isinstance(clock, ReadableClock):
        raise TypeError(
            f"Received throttle_time_source_type of '{type(clock).__name__}' is not a Clock instance"
        )
    return CallState(severity, bool(options.get("once")), bool(options.get("skip_first")), period_s, clock)
