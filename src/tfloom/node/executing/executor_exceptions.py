"""Exceptions by which a wait of an executor ends without a callback to run."""

from __future__ import annotations

from tfloom.ros_imports.guard import ros_home

__all__ = [
    "ConditionReachedException",
    "ShutdownException",
    "TimeoutException",
    "TimeoutObject",
]

# ROS's own names


class TimeoutException(Exception):
    """Nothing became ready in time."""

    __module__ = ros_home("rclpy.executors", __name__)


class ShutdownException(Exception):
    """The executor was shut down."""

    __module__ = ros_home("rclpy.executors", __name__)


class ConditionReachedException(Exception):
    """The condition of a wait is true."""

    __module__ = ros_home("rclpy.executors", __name__)


class TimeoutObject:
    """A timeout [s] that may be changed between two waits; None and negative values mean no limit."""

    def __init__(self, timeout: float | None) -> None:
        self._timeout = timeout

    @property
    def timeout(self) -> float | None:
        """The timeout [s]."""
        return self._timeout

    @timeout.setter
    def timeout(self, timeout: float | None) -> None:
        self._timeout = timeout
