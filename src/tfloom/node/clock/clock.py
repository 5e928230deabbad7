"""Clocks: system, steady and ROS time, and callbacks for time jumps."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from tfloom.common.seconds import duration_error
from tfloom.node.clock.time_jump import ANY_JUMP, SOURCE_CHANGES, ClockChange, JumpThreshold, TimeJump
from tfloom.node.context.utilities import get_default_context
from tfloom.node.values.callback_errors import call_all
from tfloom.node.values.duration import S_TO_NS, Duration
from tfloom.node.values.exceptions import NotInitializedException
from tfloom.node.values.handle import Handle
from tfloom.node.values.time import ClockType, ReadableClock, Time
from tfloom.ros_imports.ros_distro import warn_if_removed

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from tfloom.node.context.context import Context

__all__ = ["Clock", "JumpHandle", "JumpHandlePreCallbackType", "ROSClock"]

JumpHandlePreCallbackType = Callable[[], None]

_MAX_SLICE_S = 1.0
"""The longest single wait of a sleep by system time [s], because the system's clock may be set during it."""


class JumpHandle:
    """A pair of jump callbacks, registered until `unregister` or the exit of its `with` block."""

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: JumpHandlePreCallbackType | None,
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
        """Unregister the callbacks."""
        if self._clock is not None:
            self._clock.remove_jump_handle(self)
            self._clock = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.unregister()


class Clock(ReadableClock):
    """A clock. `Clock(clock_type=ClockType.ROS_TIME)` returns a ROSClock."""

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Self:
        """Return a ROSClock for ROS_TIME, else a clock of this class."""
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        wanted = ROSClock if clock_type is ClockType.ROS_TIME else cls
        return object.__new__(wanted)  # type: ignore[return-value]  # a ROSClock is a Clock

    def __init__(self, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        super().__init__(clock_type=clock_type)
        self._lock = threading.RLock()
        """Guards `_handles`, and in a ROSClock the source and the simulated time."""
        self._handles: list[JumpHandle] = []

    @property
    def handle(self) -> Handle:
        """Proxy of the clock, for code that expects rclpy's C handle."""
        return Handle(self)

    def __repr__(self) -> str:
        return f"Clock(clock_type={self._clock_type.name})"

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: JumpHandlePreCallbackType | None = None,
        post_callback: Callable[[TimeJump], None] | None = None,
    ) -> JumpHandle:
        """Call callbacks before and after each jump that passes `threshold`.

        They are called on the thread that sets the clock. Only simulated time jumps, because the operating system
        reports no changes of its clock.

        Returns:
            The handle; its `unregister` removes the callbacks.

        Raises:
            ValueError: neither callback is given, or one isn't callable.
        """
        return JumpHandle(
            clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post_callback
        )

    def jump_handles(self) -> list[JumpHandle]:
        """Return the registered handles."""
        with self._lock:
            return list(self._handles)

    def add_jump_handle(self, handle: JumpHandle) -> None:
        """Register a handle; `JumpHandle` calls this."""
        with self._lock:
            self._handles.append(handle)

    def remove_jump_handle(self, handle: JumpHandle) -> None:
        """Remove a handle; `JumpHandle.unregister` calls this."""
        with self._lock:
            if handle in self._handles:
                self._handles.remove(handle)

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Wait until the time of the clock is `until`.

        Returns:
            False if the context was shut down, or the clock's source changed, before; True otherwise.

        Raises:
            ValueError: `until` has another clock type.
            NotInitializedException: the context isn't initialised.
        """
        if not hasattr(until, "clock_type"):
            raise AttributeError(
                f"sleep_until() needs a Time, got {until!r} of class {type(until).__name__}: "
                "write clock.now() + Duration(seconds=…)"
            )
        context = context or get_default_context()
        if not context.ok():
            raise NotInitializedException
        if until.clock_type != self._clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        woken = threading.Event()
        source_changed = False

        def on_jump(jump: TimeJump) -> None:
            nonlocal source_changed
            if jump.clock_change in SOURCE_CHANGES:
                source_changed = True
            woken.set()

        # Registered before the time is read for the first time, so that no jump, and no shutdown, is missed in between.
        with self.create_jump_callback(ANY_JUMP, post_callback=on_jump):
            context.add_shutdown_hook(woken.set)
            try:
                while context.ok() and not source_changed:
                    left_ns = until.nanoseconds - self.now_ns()
                    if left_ns <= 0:
                        return True
                    # Simulated time changes by jumps alone. That of the machine may be set without a word, so it is
                    # read again after a while.
                    woken.wait(None if self._is_simulated() else min(left_ns / S_TO_NS, _MAX_SLICE_S))
                    woken.clear()
            finally:
                context.remove_shutdown_hook(woken.set)
        return False

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        """Wait for a duration by this clock; results and errors as of `sleep_until`."""
        if not isinstance(rel_time, Duration):
            raise duration_error("sleep_for() needs a Duration", rel_time)
        return self.sleep_until(self.now() + rel_time, context)

    def _is_simulated(self) -> bool:
        """Return whether the time changes only when it is set."""
        return False


class ROSClock(Clock):
    """System time, or simulated time while that is active; `Clock(clock_type=ClockType.ROS_TIME)` makes one, too."""

    def __new__(cls, *, clock_type: ClockType = ClockType.ROS_TIME) -> Self:
        """Return a ROS clock; a DeprecationWarning from Lyrical on."""
        warn_if_removed("rclpy.clock.ROSClock")
        return super().__new__(cls, clock_type=clock_type)

    def __init__(self, *, clock_type: ClockType = ClockType.ROS_TIME) -> None:
        super().__init__(clock_type=clock_type)
        self._is_active = False
        self._override_ns = 0

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clock returns simulated time."""
        return self._is_active

    def _is_simulated(self) -> bool:
        return self._is_active

    def set_ros_time_is_active(self, enabled: bool) -> None:
        """Activate or deactivate simulated time; a TimeSource calls this."""
        with self._lock:
            if enabled == self._is_active:
                return
            kind = ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED
            jump = TimeJump(kind, Duration())

        def change() -> None:
            with self._lock:
                self._is_active = enabled
                self._read_ns = self._read_override_ns if enabled else time.time_ns

        self._jump(jump, change)

    _set_ros_time_is_active = set_ros_time_is_active
    """The method by rclpy's name, which programs' tests call."""

    def set_ros_time_override(self, time: Time) -> None:
        """Set simulated time, which the clock returns while simulated time is active.

        Raises:
            TypeError: `time` is not a Time.
        """
        if not isinstance(time, Time):
            raise TypeError(f"Time must be specified as rclpy.time.Time. Received type: {type(time)}")
        with self._lock:
            if not self._is_active:
                self._override_ns = time.nanoseconds
                return
            delta = Duration(nanoseconds=time.nanoseconds - self._override_ns)
            jump = TimeJump(ClockChange.ROS_TIME_NO_CHANGE, delta)

        def change() -> None:
            with self._lock:
                self._override_ns = time.nanoseconds

        self._jump(jump, change)

    def _read_override_ns(self) -> int:
        return self._override_ns

    def _jump(self, jump: TimeJump, change: Callable[[], None]) -> None:
        """Make a change, with the callbacks of those that it concerns before and after it.

        They run without the lock. One that raises prevents neither the change nor the others: its exception is raised
        at the end, to the thread that sets the clock.
        """
        handles = [handle for handle in self.jump_handles() if handle.threshold.is_passed_by(jump)]
        pre_callbacks = [handle.pre_callback for handle in handles if handle.pre_callback is not None]
        post_callbacks = [
            partial(handle.post_callback, jump) for handle in handles if handle.post_callback is not None
        ]
        call_all([*pre_callbacks, change, *post_callbacks])
