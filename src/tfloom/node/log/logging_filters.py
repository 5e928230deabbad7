"""Filters of logger calls: once, skip the first, at most one in a period."""

from __future__ import annotations

import time
from types import CodeType
from typing import Any, NamedTuple

from tfloom.node.log.logging_severity import LoggingSeverity
from tfloom.node.values.constants import S_TO_NS
from tfloom.node.values.readable_clock import ReadableClock

__all__ = ["CallState", "CallerId", "options_error"]

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

    __slots__ = ("_last_ns", "_name", "_options", "_severity", "_skips_next", "_was_logged")

    def __init__(self, severity: LoggingSeverity, name: str, options: dict[str, Any]) -> None:
        self._severity = severity
        self._name = name
        self._options = options
        self._skips_next = bool(options.get("skip_first"))
        self._was_logged = False
        self._last_ns: int | None = None

    def check_unchanged(self, severity: LoggingSeverity, name: str, options: dict[str, Any]) -> None:
        """Compare a call with the first one of this place.

        Raises:
            ValueError: it has another severity, another logger's name, or other filters.
        """
        if severity != self._severity:
            raise ValueError("Logger severity cannot be changed between calls.")
        if name != self._name:
            raise ValueError("Logger name cannot be changed between calls.")
        if _filters(options) != _filters(self._options):
            raise ValueError("Requested logging filters cannot be changed between calls.")
        if any(options.get(parameter) != self._options.get(parameter) for parameter in _PARAMETERS):
            raise ValueError("Logging filter parameters cannot be changed between calls.")

    def lets_through(self) -> bool:
        """Return whether this call is to be logged, and count it."""
        # In this order, as in rclpy: the period also starts with a call that `skip_first` drops, and the one call of
        # `once` is the first that the other two let through.
        if not self._is_due():
            return False
        if self._skips_next:
            self._skips_next = False
            return False
        if self._was_logged and self._options.get("once"):
            return False
        self._was_logged = True
        return True

    def _is_due(self) -> bool:
        """Return whether the period since the last call that was due has passed; it starts anew then."""
        period_s = self._options.get("throttle_duration_sec")
        if period_s is None:
            return True
        clock: ReadableClock | None = self._options.get("throttle_time_source_type")
        now_ns = time.monotonic_ns() if clock is None else clock.now().nanoseconds
        # After a jump backward of the clock, the period starts anew.
        if self._last_ns is not None and 0 <= now_ns - self._last_ns < int(period_s * S_TO_NS):
            return False
        self._last_ns = now_ns
        return True


def _filters(options: dict[str, Any]) -> set[str]:
    return {_PARAMETERS[name] for name, value in options.items() if value}


def options_error(options: dict[str, Any]) -> TypeError | ValueError | None:
    """Return the error of the options of a logger call: one is unknown, lacks another, or is of the wrong type."""
    for name in options:
        if name not in _PARAMETERS:
            option_names = ", ".join(_PARAMETERS)
            return TypeError(
                f'parameter "{name}" is not one of the recognized logging options "{option_names}"'
            )
    period_s = options.get("throttle_duration_sec")
    clock = options.get("throttle_time_source_type")
    if period_s is not None and not hasattr(period_s, "__float__"):
        return TypeError(f"throttle_duration_sec must be a number of seconds, not {type(period_s).__name__}")
    if clock is not None and period_s is None:
        return TypeError(
            'required parameter "throttle_duration_sec" not specified but is required for the the logging filter '
            '"throttle"'
        )
    if clock is not None and not isinstance(clock, ReadableClock):
        return ValueError(  # as in rclpy
            f'Received throttle_time_source_type of "{clock}" is not a clock instance'
        )
    return None
