"""The kinds of clocks."""

from __future__ import annotations

from enum import IntEnum

__all__ = ["ClockType"]


class ClockType(IntEnum):
    """Which clock a time was read from; times of different clocks don't compare."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    """Simulated time while it is on, else system time."""
    SYSTEM_TIME = 2
    """Since the epoch; the operating system may set it forward and back."""
    STEADY_TIME = 3
    """Since some start; never goes back."""
