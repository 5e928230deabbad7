"""The kinds of clocks."""

from __future__ import annotations

from enum import IntEnum

__all__ = ["ClockType"]


class ClockType(IntEnum):
    """The clock that a time was read from; times of different clocks can't be compared."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    """Simulated time while it is active, else system time."""
    SYSTEM_TIME = 2
    """Time since the epoch; the operating system may set it forward and backward."""
    STEADY_TIME = 3
    """Time since an arbitrary start; it never decreases."""
