"""A clock that can be read: the base of `Clock`, sufficient for a throttled logger."""

from __future__ import annotations

import time

from tfloom.node.values.clock_type import ClockType
from tfloom.node.values.time import Time, make_time

__all__ = ["ReadableClock"]


class ReadableClock:
    """Returns system or steady time; `clock/clock.py` adds jumps, sleeping and simulated time."""

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self._clock_type = clock_type
        self._read_ns = time.monotonic_ns if clock_type is ClockType.STEADY_TIME else time.time_ns

    @property
    def clock_type(self) -> ClockType:
        """The kind of clock."""
        return self._clock_type

    def now(self) -> Time:
        """Return the current time of this clock."""
        return make_time(self._read_ns(), self._clock_type)

    def now_ns(self) -> int:
        """Return the current time of this clock [ns]."""
        return self._read_ns()
