"""Clocks: system, steady and ROS time, and what happens when one jumps."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from enum import IntEnum
from typing import TYPE_CHECKING

from tfloom.node.values.clock_type import ClockType
from tfloom.node.values.duration import Duration
from tfloom.node.values.handle import Handle
from tfloom.node.values.time import Time, make_time

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom.node.context.context import Context

__all__ = ["Clock", "ClockChange", "ClockType", "JumpHandle", "JumpThreshold", "ROSClock", "TimeJump"]


class ClockChange(IntEnum):
    """What became of a clock's source at a jump."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class JumpThreshold:
    """Which jumps a callback is to hear of.

    Args:
        min_forward: The least jump forward, above 0; None for no jump forward.
        min_backward: The least jump backward, below 0; None for no jump backward.
        on_clock_change: Whether to hear of simulated time being turned on or off.

    Raises:
        ValueError: `min_forward` is not above, or `min_backward` not below, zero.
    """

    def __init__(
        self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError("min_forward must be a positive non-zero duration")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError("min_backward must be a negative non-zero duration")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def is_passed_by(self, jump: TimeJump) -> bool:
        """Return whether `jump` is one of these."""
        if jump.clock_change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            return self.on_clock_change
        if self.min_forward is not None and jump.delta >= self.min_forward:
            return True
        return self.min_backward is not None and jump.delta <= self.min_backward


class TimeJump:
    """A jump of a clock: by how much, and whether its source changed."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        """What became of the source."""
        return self._clock_change

    @property
    def delta(self) -> Duration:
        """How far: negative for a jump back."""
        return self._delta


class JumpHandle:
    """A pair of jump callbacks, registered until `unregister` or the end of a `with`."""

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], None] | None,
        post_callback: Callable[[TimeJump], None] | None,
    ) -> None:
        if not isinstance(clock, Clock):
            raise TypeError("clock must be an instance of rclpy.clock.Clock")
        if not isinstance(threshold, JumpThreshold):
            raise TypeError("threshold must be an instance of rclpy.clock.JumpThreshold")
        for name, callback in (("pre_callback", pre_callback), ("post_callback", post_callback)):
            if callback is not None and not callable(callback):
                raise ValueError(f"{name} must be callable if given")
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        self.threshold = threshold
        self.pre_callback = pre_callback
        self.post_callback = post_callback
        self._clock: Clock | None = clock
        clock.add_jump_handle(self)

    def unregister(self) -> None:
        """Call the callbacks no more."""
        if self._clock is not None:
            self._clock.remove_jump_handle(self)
            self._clock = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.unregister()


class Clock:
    """Tells the time. `Clock(clock_type=ClockType.ROS_TIME)` gives a ROSClock."""

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Self:
        """Return a clock of the class that `clock_type` asks for."""
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        wanted = ROSClock if clock_type is ClockType.ROS_TIME else cls
        return object.__new__(wanted)  # type: ignore[return-value]  # a ROSClock is a Clock, and only Clock is asked

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        self._clock_type = clock_type
        self._lock = threading.RLock()
        self._handles: list[JumpHandle] = []
        self._read_ns = time.monotonic_ns if clock_type is ClockType.STEADY_TIME else time.time_ns

    @property
    def clock_type(self) -> ClockType:
        """What kind of clock it is."""
        return self._clock_type

    @property
    def handle(self) -> Handle:
        """What stands for the library's own clock."""
        return Handle(self)

    def __repr__(self) -> str:
        return f"Clock(clock_type={self._clock_type.name})"

    def now(self) -> Time:
        """Return the time it is by this clock."""
        return make_time(self._read_ns(), self._clock_type)

    def now_ns(self) -> int:
        """Return the time it is by this clock [ns]."""
        return self._read_ns()

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], None] | None = None,
        post_callback: Callable[[TimeJump], None] | None = None,
    ) -> JumpHandle:
        """Have callbacks called before and after each jump that passes `threshold`.

        They are called on the thread that sets the clock. Only simulated time jumps: the operating system
        doesn't tell of changes to its own.

        Returns:
            The handle whose `unregister` ends it.

        Raises:
            ValueError: neither callback is given, or one isn't callable.
        """
        return JumpHandle(
            clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post_callback
        )

    def jump_handles(self) -> list[JumpHandle]:
        """Return what is registered now."""
        with self._lock:
            return list(self._handles)

    def add_jump_handle(self, handle: JumpHandle) -> None:
        """Register a handle; each handle does it for itself."""
        with self._lock:
            self._handles.append(handle)

    def remove_jump_handle(self, handle: JumpHandle) -> None:
        """Take a handle off again."""
        with self._lock:
            if handle in self._handles:
                self._handles.remove(handle)

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Wait until the clock shows `until`.

        Returns:
            False if shutdown came first, or the clock's source changed; True otherwise.

        Raises:
            ValueError: `until` is of another clock.
            NotInitializedException: the context isn't initialised.
        """
        from tfloom.node.clock.clock_sleep import sleep_until

        return sleep_until(self, until, context)

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        """Wait for a span of time by this clock; as `sleep_until`."""
        return self.sleep_until(self.now() + rel_time, context)


class ROSClock(Clock):
    """System time, or simulated time while that is on."""

    def __new__(cls, *, clock_type: ClockType = ClockType.ROS_TIME) -> Self:
        """Return a ROS clock."""
        return super().__new__(cls, clock_type=clock_type)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=clock_type)
        self._is_active = False
        self._override_ns = 0

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clock shows simulated time."""
        return self._is_active

    def set_ros_time_is_active(self, enabled: bool) -> None:
        """Turn simulated time on or off; a TimeSource does it."""
        with self._lock:
            if enabled == self._is_active:
                return
            before_ns = self.now_ns()
            after_ns = self._override_ns if enabled else time.time_ns()
            change = ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED
            jump = TimeJump(change, Duration(nanoseconds=after_ns - before_ns))
            handles = self._begin_jump(jump)
            self._is_active = enabled
            self._read_ns = self._read_override_ns if enabled else time.time_ns
        self._end_jump(handles, jump)

    def set_ros_time_override(self, time: Time) -> None:
        """Set simulated time, which shows once it is turned on.

        Raises:
            TypeError: `time` is no Time.
        """
        if not isinstance(time, Time):
            raise TypeError(f"Time must be specified as rclpy.time.Time. Received type: {type(time)}")
        with self._lock:
            if not self._is_active:
                self._override_ns = time.nanoseconds
                return
            delta = Duration(nanoseconds=time.nanoseconds - self._override_ns)
            jump = TimeJump(ClockChange.ROS_TIME_NO_CHANGE, delta)
            handles = self._begin_jump(jump)
            self._override_ns = time.nanoseconds
        self._end_jump(handles, jump)

    def _read_override_ns(self) -> int:
        return self._override_ns

    def _begin_jump(self, jump: TimeJump) -> list[JumpHandle]:
        handles = [handle for handle in self._handles if handle.threshold.is_passed_by(jump)]
        for handle in handles:
            if handle.pre_callback is not None:
                handle.pre_callback()
        return handles

    @staticmethod
    def _end_jump(handles: list[JumpHandle], jump: TimeJump) -> None:
        for handle in handles:
            if handle.post_callback is not None:
                handle.post_callback(jump)
