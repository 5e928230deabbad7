"""Errors that several rooms raise or catch; every other error is defined beside the code that raises it.

Exception
├── NoTypeSupportImportedException
├── NotInitializedException
├── ROSInterruptException
├── TimeSourceChangedError
├── ExternalShutdownException
├── TimeoutException, ShutdownException, ConditionReachedException   a wait of an executor ended
└── RuntimeError
    ├── InvalidHandle
    └── RCLError
        ├── NodeNameNonExistentError
        └── TimerCancelledError
"""

from __future__ import annotations

from tfloom.ros_imports.guard import ros_home

__all__ = [
    "ConditionReachedException",
    "ExternalShutdownException",
    "ForkedProcessError",
    "InvalidHandle",
    "NoTypeSupportImportedException",
    "NodeNameNonExistentError",
    "NotInitializedException",
    "RCLError",
    "ROSInterruptException",
    "ShutdownException",
    "TimeSourceChangedError",
    "TimeoutException",
    "TimeoutObject",
    "TimerCancelledError",
    "add_note",
]


def add_note(error: BaseException, note: str) -> None:
    """Add a line that Python 3.11 and later print below the error, whose own text is the reference's."""
    error.__notes__ = [*getattr(error, "__notes__", ()), note]  # type: ignore[attr-defined]  # new in 3.11


# ROS's own names end in "Exception".
# ruff: noqa: N818


class InvalidHandle(RuntimeError):
    """An object was used after it was destroyed."""

    __module__ = ros_home("rclpy._rclpy_pybind11", __name__)


class NotInitializedException(Exception):
    """`rclpy.init()` has not been called, or the context has been shut down since."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self, message: str | None = None) -> None:
        reason = "" if message is None else f" msg:{message}"
        super().__init__(f"rclpy.init() has not been called.{reason}")


class ROSInterruptException(Exception):
    """A wait ended because the context was shut down."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self) -> None:
        super().__init__("rclpy.shutdown() has been called")


class TimeSourceChangedError(Exception):
    """A sleep ended because simulated time was switched on or off, so that its end is on another clock."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self) -> None:
        super().__init__("simulated time was switched on or off during the sleep")


class ExternalShutdownException(Exception):
    """The context was shut down while an executor was spinning."""

    __module__ = ros_home("rclpy.executors", __name__)

    def __init__(self) -> None:
        super().__init__("the context was shut down, by a signal or by another thread")


class TimeoutException(Exception):
    """Nothing became ready in time for an executor."""

    __module__ = ros_home("rclpy.executors", __name__)


class ShutdownException(Exception):
    """An executor that waited was shut down."""

    __module__ = ros_home("rclpy.executors", __name__)


class ConditionReachedException(Exception):
    """The condition that an executor waited for is true."""

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


class NoTypeSupportImportedException(Exception):
    """Kept for programs that catch it; a class that is not a ROS type raises AttributeError."""

    __module__ = ros_home("rclpy.exceptions", __name__)

    def __init__(self) -> None:
        super().__init__("no type_support imported")


class RCLError(RuntimeError):
    """An operation failed in the layer below, for example because the context is shut down."""

    __module__ = ros_home("rclpy._rclpy_pybind11", __name__)


class ForkedProcessError(NotInitializedException, RCLError):
    """A forked process used a context, or something of a context, that its parent had initialised.

    Args:
        what: What can't be done.
    """

    def __init__(self, what: str) -> None:
        from tfloom.rmw.forks import lasting_advice

        advice = lasting_advice() or (
            "a fork has none of the threads that send and receive. In the child, call rclpy.init() and create the "
            "node anew, or start the child by multiprocessing's method 'spawn'"
        )
        Exception.__init__(self, f"{what}: its context was initialised by the parent process, and {advice}")


class NodeNameNonExistentError(RCLError):
    """A query names a node that isn't on the graph."""

    __module__ = ros_home("rclpy._rclpy_pybind11", __name__)


class TimerCancelledError(RCLError):
    """A cancelled timer was called."""
