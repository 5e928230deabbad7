"""Filters of logger calls: once, skip the first, at most one in a period."""

from __future__ import annotations

import time
from contextlib import suppress
from types import CodeType
from typing import Any, NamedTuple

from tfloom.common.seconds import checked_timeout, to_nanoseconds
from tfloom.node.log.log_output import LoggingSeverity
from tfloom.node.values.duration import INT64_MAX
from tfloom.node.values.time import ReadableClock

__all__ = ["CallState", "CallerId", "FilterTable", "options_error", "place_of"]

MAX_FILTERS = 10_000
"""Most places that a table remembers."""

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


class Place(NamedTuple):
    """What a filter holds for: calls of one place, by loggers of one name, with the same options."""

    name: str
    caller: CallerId
    severity: LoggingSeverity
    once: bool
    skip_first: bool
    period_ns: int | None
    clock_type: object


class CallFilter:
    """What the filters remember of the calls of a place."""

    __slots__ = ("_last_ns", "_skips_next", "_was_logged")

    def __init__(self, *, skips_first: bool) -> None:
        self._skips_next = skips_first
        self._was_logged = False
        self._last_ns: int | None = None

    def lets_through(self, place: Place, clock: ReadableClock | None) -> bool:
        """Return whether this call is to be logged, and count it."""
        # In this order, as in rclpy: the period also starts with a call that `skip_first` drops, and the one call of
        # `once` is the first that the other two let through.
        if place.period_ns is not None and not self._is_due(place.period_ns, clock):
            return False
        if self._skips_next:
            self._skips_next = False
            return False
        if self._was_logged and place.once:
            return False
        self._was_logged = True
        return True

    def _is_due(self, period_ns: int, clock: ReadableClock | None) -> bool:
        """Return whether the period since the last call that was due has passed; it starts anew then."""
        now_ns = time.monotonic_ns() if clock is None else clock.now().nanoseconds
        # After a jump backward of the clock, the period starts anew.
        if self._last_ns is not None and 0 <= now_ns - self._last_ns < period_ns:
            return False
        self._last_ns = now_ns
        return True


class FilterTable:
    """The filters of loggers, by place, which all loggers of a name share: programs fetch one for each call."""

    def __init__(self) -> None:
        self._filters: dict[Place, CallFilter] = {}
        """Changed by single operations."""

    def filter_of(self, place: Place) -> CallFilter:
        """Return the filter of a place; that of the oldest place is forgotten beyond MAX_FILTERS."""
        found = self._filters.setdefault(place, CallFilter(skips_first=place.skip_first))
        while len(self._filters) > MAX_FILTERS:
            with suppress(StopIteration, RuntimeError):  # another thread was faster
                self._filters.pop(next(iter(self._filters)), None)
        return found


class CallState:
    """How a logger was called first at a place, and the filter of that place."""

    __slots__ = ("_clock", "_filter", "_options", "_place")

    def __init__(self, table: FilterTable, place: Place, options: dict[str, Any]) -> None:
        self._place = place
        self._options = options
        self._clock: ReadableClock | None = options.get("throttle_time_source_type")
        self._filter = table.filter_of(place)

    def check_unchanged(self, severity: LoggingSeverity, name: str, options: dict[str, Any]) -> None:
        """Compare a call with the first one of this place.

        Raises:
            ValueError: it has another severity, another logger's name, or other filters.
        """
        if severity != self._place.severity:
            raise ValueError("Logger severity cannot be changed between calls.")
        if name != self._place.name:
            raise ValueError("Logger name cannot be changed between calls.")
        if _filters(options) != _filters(self._options):
            raise ValueError("Requested logging filters cannot be changed between calls.")
        # `once=False` is as no `once`.
        if any((options.get(name) or None) != (self._options.get(name) or None) for name in _PARAMETERS):
            raise ValueError("Logging filter parameters cannot be changed between calls.")

    def lets_through(self) -> bool:
        """Return whether this call is to be logged, and count it."""
        return self._filter.lets_through(self._place, self._clock)


def place_of(caller: CallerId, severity: LoggingSeverity, name: str, options: dict[str, Any]) -> Place:
    """Return the place of a call whose options have no error."""
    period_s = options.get("throttle_duration_sec")
    limit_s = checked_timeout("throttle_duration_sec", period_s)
    period_ns = None if period_s is None else INT64_MAX if limit_s is None else to_nanoseconds(limit_s)
    clock = options.get("throttle_time_source_type")
    once, skip_first = bool(options.get("once")), bool(options.get("skip_first"))
    return Place(name, caller, severity, once, skip_first, period_ns, clock and clock.clock_type)


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
    if period_s != period_s:  # noqa: PLR0124  # NaN, of any class
        return ValueError(f"throttle_duration_sec must be a number of seconds, not {period_s}")
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
