"""Durations, and the limits of times."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Protocol

from tfloom.common.seconds import given_time, no_time_of, not_a_number, plain_value, to_nanoseconds

if TYPE_CHECKING:
    from tfloom.interfaces.builtin_interfaces import msg as builtin_msg

__all__ = ["INT64_MAX", "S_TO_NS", "Duration", "DurationType", "Infinite"]

S_TO_NS = 1000 * 1000 * 1000
"""Nanoseconds in a second."""

INT64_MAX = 2**63 - 1
"""The latest time and the longest duration [ns]: both are signed 64-bit counts."""


class DurationType(Protocol):
    """Type of the result of `Duration.get_c_duration`."""

    @property
    def nanoseconds(self) -> int:
        """The duration [ns]."""


class Duration:
    """A duration as a signed 64-bit count of nanoseconds.

    Args:
        seconds: Whole or fractional seconds; truncated to nanoseconds.
        nanoseconds: Added to `seconds`.

    Raises:
        OverflowError: the sum doesn't fit 64 bits (about 292 years).
        ValueError: `seconds` is a text.
        TypeError: a part is not a number.
    """

    __slots__ = ("_ns",)

    def __init__(self, *, seconds: float = 0, nanoseconds: int = 0) -> None:
        if isinstance(seconds, str):
            raise ValueError(f"Duration {not_a_number('seconds', seconds)}")
        try:
            total = to_nanoseconds(seconds) + int(nanoseconds)
        except TypeError:
            raise TypeError(no_time_of("Duration", seconds, nanoseconds)) from None
        if not -INT64_MAX - 1 <= total <= INT64_MAX:
            raise OverflowError("Total nanoseconds value is too large to store in C duration.")
        self._ns = total

    @property
    def nanoseconds(self) -> int:
        """The duration [ns]."""
        return self._ns

    def get_c_duration(self) -> DurationType:
        """Return this object, in place of rclpy's C duration."""
        return self

    def to_msg(self) -> builtin_msg.Duration:
        """Return the duration as a message: `sec` rounded down, `nanosec` in [0, 1e9)."""
        from tfloom.interfaces.builtin_interfaces import msg as builtin_msg

        sec, nanosec = divmod(self._ns, S_TO_NS)
        return builtin_msg.Duration(sec=sec, nanosec=nanosec)

    @classmethod
    def from_msg(cls, msg: builtin_msg.Duration) -> Duration:
        """Return the duration in a `builtin_interfaces/msg/Duration`.

        Raises:
            TypeError: `msg` is not such a message.
        """
        from tfloom.interfaces.builtin_interfaces import msg as builtin_msg

        if not isinstance(msg, builtin_msg.Duration):
            raise TypeError(f"Must pass a builtin_interfaces.msg.Duration object{given_time(msg)}")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self._ns})"

    def __str__(self) -> str:
        return "Infinite" if self._ns == INT64_MAX else f"{self._ns} nanoseconds"

    def __hash__(self) -> int:
        return hash((Duration, self._ns))

    def __add__(self, other: Duration) -> Duration:
        return Duration(nanoseconds=self._ns + other._ns) if isinstance(other, Duration) else NotImplemented

    def __sub__(self, other: Duration) -> Duration:
        return Duration(nanoseconds=self._ns - other._ns) if isinstance(other, Duration) else NotImplemented

    def __mul__(self, other: float) -> Duration:
        """Return this duration times a number, truncated to nanoseconds; times infinity: `Infinite`.

        Raises:
            ValueError: the number is NaN, or negative infinity.
            OverflowError: the product doesn't fit 64 bits.
        """
        factor = plain_value(other)
        if not isinstance(factor, (int, float)):
            return NotImplemented
        if isinstance(factor, int) or math.isfinite(factor):
            return Duration(nanoseconds=int(self._ns * factor))
        if factor == math.inf:
            return Infinite
        raise ValueError(f"Can't multiply duration with {factor}")

    def __eq__(self, other: object) -> bool:
        return self._ns == other._ns if isinstance(other, Duration) else NotImplemented

    def __lt__(self, other: Duration) -> bool:
        return self._ns < other._ns if isinstance(other, Duration) else NotImplemented

    def __le__(self, other: Duration) -> bool:
        return self._ns <= other._ns if isinstance(other, Duration) else NotImplemented

    def __gt__(self, other: Duration) -> bool:
        return self._ns > other._ns if isinstance(other, Duration) else NotImplemented

    def __ge__(self, other: Duration) -> bool:
        return self._ns >= other._ns if isinstance(other, Duration) else NotImplemented


Infinite = Duration(nanoseconds=INT64_MAX)
"""The duration that stands for no limit."""
