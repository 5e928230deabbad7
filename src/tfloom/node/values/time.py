"""Time: a point in time on one clock; the kinds of clocks, and a clock that can be read."""

from __future__ import annotations

import time
from enum import IntEnum
from typing import TYPE_CHECKING, overload

from tfloom.common.seconds import given_time, no_time_of, to_nanoseconds
from tfloom.common.text import describe_machine_clock
from tfloom.node.values.duration import INT64_MAX, S_TO_NS, Duration
from tfloom.node.values.exceptions import RCLError

if TYPE_CHECKING:
    from datetime import datetime

    from tfloom.interfaces.builtin_interfaces import msg as builtin_msg

__all__ = ["S_TO_NS", "ClockType", "ReadableClock", "Time", "check_fits_stamp"]


class ClockType(IntEnum):
    """The clock that a time was read from; times of different clocks can't be compared."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    """Simulated time while it is active, else system time."""
    SYSTEM_TIME = 2
    """Time since the epoch; the operating system may set it forward and backward."""
    STEADY_TIME = 3
    """Time since an arbitrary start; it never decreases."""


MIN_STAMP_NS = -(2**31) * S_TO_NS
MAX_STAMP_NS = 2**31 * S_TO_NS - 1
"""The earliest and the latest time that a `builtin_interfaces/msg/Time` can hold: its seconds are an int32."""


class Time:
    """A point in time on one clock, as nanoseconds since that clock's zero.

    Args:
        seconds: Whole or fractional seconds, not negative.
        nanoseconds: Added to `seconds`, not negative.
        clock_type: The clock that the time belongs to.

    Raises:
        ValueError: a part is negative.
        TypeError: `clock_type` is not a ClockType.
        OverflowError: the sum doesn't fit a signed 64-bit count.
    """

    __slots__ = ("_clock_type", "_ns")

    def __init__(
        self,
        *,
        seconds: float = 0,
        nanoseconds: int = 0,
        clock_type: ClockType = ClockType.SYSTEM_TIME,
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        try:
            # NaN, which is not equal to itself, can't be compared in each class; the conversion refuses it.
            if seconds == seconds and seconds < 0:  # noqa: PLR0124
                raise ValueError("Seconds value must not be negative")
            if nanoseconds == nanoseconds and nanoseconds < 0:  # noqa: PLR0124
                raise ValueError("Nanoseconds value must not be negative")
            total = to_nanoseconds(seconds) + int(nanoseconds)
        except TypeError:
            raise TypeError(no_time_of("Time", seconds, nanoseconds)) from None
        if total > INT64_MAX:
            raise OverflowError("Total nanoseconds value is too large to store in C time point.")
        self._ns = total
        self._clock_type = clock_type

    @property
    def nanoseconds(self) -> int:
        """Time since the clock's zero [ns]."""
        return self._ns

    @property
    def clock_type(self) -> ClockType:
        """The clock that the time belongs to."""
        return self._clock_type

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Return whole seconds, and the remaining nanoseconds."""
        return divmod(self._ns, S_TO_NS)

    def to_msg(self) -> builtin_msg.Time:
        """Return the time as a message, which has no clock type."""
        from tfloom.interfaces.builtin_interfaces import msg as builtin_msg

        sec, nanosec = divmod(self._ns, S_TO_NS)
        return builtin_msg.Time(sec=sec, nanosec=nanosec)

    @classmethod
    def from_msg(cls, msg: builtin_msg.Time, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        """Return the time in a `builtin_interfaces/msg/Time`, on the clock of `clock_type`.

        Raises:
            TypeError: `msg` is not such a message.
            ValueError: its seconds are negative.
        """
        from tfloom.interfaces.builtin_interfaces import msg as builtin_msg

        if not isinstance(msg, builtin_msg.Time):
            raise TypeError(f"Must pass a builtin_interfaces.msg.Time object{given_time(msg)}")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)

    def to_datetime(self) -> datetime:
        """Return the time as local date and time, without a time zone, rounded down to microseconds.

        Raises:
            TypeError: the clock is neither ROS_TIME nor SYSTEM_TIME, whose zero is the epoch.
            OverflowError, OSError, ValueError: a date of this machine can't hold it.
        """
        from datetime import datetime, timedelta

        if self._clock_type not in {ClockType.ROS_TIME, ClockType.SYSTEM_TIME}:
            raise TypeError("Time object's clock type should be either ROS_TIME or SYSTEM_TIME")
        sec, nanosec = divmod(self._ns, S_TO_NS)
        whole = datetime.fromtimestamp(sec)  # noqa: DTZ006  # naive, as in the reference
        return whole + timedelta(microseconds=nanosec // 1000)

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self._ns}, clock_type={self._clock_type.name})"

    def __hash__(self) -> int:
        return hash((Time, self._ns, self._clock_type))

    def __add__(self, other: Duration) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        total = self._ns + other.nanoseconds
        if total < 0:
            raise ValueError("Addition leads to negative time")
        if total > INT64_MAX:
            raise OverflowError("Addition leads to overflow in C storage.")
        return make_time(total, self._clock_type)

    __radd__ = __add__

    @overload
    def __sub__(self, other: Time) -> Duration: ...
    @overload
    def __sub__(self, other: Duration) -> Time: ...
    def __sub__(self, other: Time | Duration) -> Time | Duration:
        if isinstance(other, Time):
            if self._clock_type != other._clock_type:
                raise TypeError("Can't subtract times with different clock types")
            return Duration(nanoseconds=self._ns - other._ns)
        if not isinstance(other, Duration):
            return NotImplemented
        total = self._ns - other.nanoseconds
        if total < 0:
            raise ValueError("Subtraction leads to negative time")
        if total > INT64_MAX:
            raise OverflowError("Subtraction leads to overflow in C storage.")
        return make_time(total, self._clock_type)

    def _ns_on_same_clock(self, other: Time) -> int:
        if self._clock_type != other._clock_type:
            raise TypeError("Can't compare times with different clock types")
        return other._ns

    def __eq__(self, other: object) -> bool:
        return self._ns == self._ns_on_same_clock(other) if isinstance(other, Time) else NotImplemented

    def __lt__(self, other: Time) -> bool:
        return self._ns < self._ns_on_same_clock(other) if isinstance(other, Time) else NotImplemented

    def __le__(self, other: Time) -> bool:
        return self._ns <= self._ns_on_same_clock(other) if isinstance(other, Time) else NotImplemented

    def __gt__(self, other: Time) -> bool:
        return self._ns > self._ns_on_same_clock(other) if isinstance(other, Time) else NotImplemented

    def __ge__(self, other: Time) -> bool:
        return self._ns >= self._ns_on_same_clock(other) if isinstance(other, Time) else NotImplemented


def make_time(nanoseconds: int, clock_type: ClockType) -> Time:
    """Return a Time without the constructor's checks, for clocks and other callers whose numbers are valid."""
    time = Time.__new__(Time)
    time._ns = nanoseconds  # noqa: SLF001  # in place of the constructor
    time._clock_type = clock_type  # noqa: SLF001  # as above
    return time


def check_fits_stamp(time_ns: int) -> None:
    """Raise an error that names the machine's clock if its time doesn't fit into a message of the node's own.

    Raises:
        RCLError: it doesn't.
    """
    if MIN_STAMP_NS <= time_ns <= MAX_STAMP_NS:
        return
    raise RCLError(
        f"{describe_machine_clock(time_ns)}, and messages of ROS 2 hold times from 1901 to 19 January 2038 alone. Set "
        "the clock to the present date"
    )


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
