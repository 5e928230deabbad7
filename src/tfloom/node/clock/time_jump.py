"""Time jumps of a clock, and thresholds for callbacks."""

from __future__ import annotations

from enum import IntEnum

from tfloom.node.values.duration import Duration

__all__ = ["ANY_JUMP", "SOURCE_CHANGES", "ClockChange", "JumpThreshold", "TimeJump"]


class ClockChange(IntEnum):
    """Change of a clock's source at a jump."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class JumpThreshold:
    """The jumps for which a callback is called.

    Args:
        min_forward: The least jump forward, above 0; None for no jump forward.
        min_backward: The least jump backward, below 0; None for no jump backward.
        on_clock_change: Whether the callback is called when simulated time is activated or deactivated.

    Raises:
        ValueError: `min_forward` is not above, or `min_backward` not below, zero; or no jump passes the threshold.
    """

    def __init__(
        self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True
    ) -> None:
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError("At least one jump threshold must be enabled")
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError("min_forward must be a positive non-zero duration")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError("min_backward must be a negative non-zero duration")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def is_passed_by(self, jump: TimeJump) -> bool:
        """Return whether `jump` passes the threshold."""
        if jump.clock_change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            return self.on_clock_change
        if self.min_forward is not None and jump.delta >= self.min_forward:
            return True
        return self.min_backward is not None and jump.delta <= self.min_backward


class TimeJump:
    """A jump of a clock: its size, and the change of the source."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        """Change of the source."""
        return self._clock_change

    @property
    def delta(self) -> Duration:
        """Size of the jump; negative for a jump backward, 0 where the source has changed."""
        return self._delta


SOURCE_CHANGES = (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED)
"""The changes after which a clock has another source."""

ANY_JUMP = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1))
"""A threshold that every jump passes."""
