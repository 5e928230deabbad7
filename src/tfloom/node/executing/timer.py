"""Timers, which call a callback periodically, and rates for loops."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial
from importlib import import_module
from types import MethodType
from typing import TYPE_CHECKING, Any

from tfloom.common.seconds import too_long
from tfloom.node.clock.clock import Clock, JumpHandle, ROSClock
from tfloom.node.clock.time_jump import ANY_JUMP, SOURCE_CHANGES, TimeJump
from tfloom.node.executing.entity import CallbackEntity
from tfloom.node.values.duration import INT64_MAX
from tfloom.node.values.exceptions import ROSInterruptException
from tfloom.node.values.time import ClockType, Time
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from types import TracebackType
    from typing import TypeAlias

    from typing_extensions import Self

    from tfloom._native import ReadyQueue
    from tfloom.node.context.context import Context
    from tfloom.node.executing.callback_groups import CallbackGroup

    TimerCallback: TypeAlias = Callable[[], Any] | Callable[["TimerInfo"], Any]

__all__ = ["Rate", "Timer", "TimerInfo"]


_CALL = "__call__"


class TimerInfo:
    """When a call of a timer was due, and when it began.

    Args:
        expected_call_time: When it was due, by the timer's clock [ns].
        actual_call_time: When it began, by the timer's clock [ns].
        clock_type: Kind of the timer's clock.

    Raises:
        TypeError: `clock_type` is not a ClockType.
        ValueError: a time is negative.
    """

    __slots__ = ("_actual", "_expected")

    def __init__(
        self,
        *,
        expected_call_time: int = 0,
        actual_call_time: int = 0,
        clock_type: ClockType = ClockType.SYSTEM_TIME,
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        if expected_call_time < 0 or actual_call_time < 0:
            raise ValueError("call time values must not be negative")
        self._expected = Time(nanoseconds=expected_call_time, clock_type=clock_type)
        self._actual = Time(nanoseconds=actual_call_time, clock_type=clock_type)

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def expected_call_time(self) -> Time:
        """When the call was due."""
        return self._expected

    @property
    def actual_call_time(self) -> Time:
        """When the call began."""
        return self._actual


def info_parameter(callback: Callable[..., Any] | None) -> str | None:
    """Return the parameter of a timer's callback that is annotated as TimerInfo; None if there is none."""
    function: Any = callback
    while isinstance(function, partial):
        function = function.func
    if isinstance(function, MethodType):
        function = function.__func__
    elif not hasattr(function, "__code__") and not isinstance(function, type):
        function = getattr(type(function), _CALL, function)
    for name, annotation in _annotations(function).items():
        # A text is compared without being evaluated, because what it names may be imported for type checkers alone.
        if annotation is TimerInfo or (
            isinstance(annotation, str) and annotation.strip("'\"").rpartition(".")[2] == TimerInfo.__name__
        ):
            return None if name == "return" else name
    return None


def _annotations(function: Any) -> dict[str, Any]:
    try:
        return getattr(function, "__annotations__", None) or {}
    except NameError:  # from Python 3.14 on they are evaluated when they are read
        annotationlib: Any = import_module("annotationlib")
        texts: dict[str, Any] = annotationlib.get_annotations(function, format=annotationlib.Format.STRING)
        return texts


class Timer(CallbackEntity):
    """Calls its callback once a period.

    Missed calls are skipped: the next call is at the next whole period. The period is measured in simulated time if
    the clock shows it, else by the steady clock, because that isn't affected by setting the system's clock.

    Where an executor has four or more timers due within the same millisecond, one wake serves them all, after the last
    of their deadlines.

    Args:
        callback: Called without arguments, or with a TimerInfo as the parameter that is annotated as such.
        callback_group: Its group.
        timer_period_ns: The period [ns]; a timer of period 0 is always ready.
        clock: Clock of the period.
        context: Unused; kept for rclpy's signature.
        autostart: Whether it is started at once; otherwise by the first `reset`.

    Raises:
        ValueError: the period is negative, NaN, or longer than 292 years.
    """

    is_timed = True
    _kind = "timer"

    def __init__(
        self,
        callback: TimerCallback | None,
        callback_group: CallbackGroup | None,
        timer_period_ns: int,
        clock: Clock,
        *,
        context: Context | None = None,
        autostart: bool = True,
    ) -> None:
        self._period_ns = _checked_period(timer_period_ns)
        self.callback = callback
        self.callback_group = callback_group
        self._clock = clock
        self._ros_clock = clock if isinstance(clock, ROSClock) else None
        self._canceled = not autostart
        self._lock = threading.RLock()
        """Guards `_last_ns` and `_next_ns`; single reads take no lock."""
        self._last_ns = self._now_ns()
        self._next_ns = self._last_ns + self._period_ns
        self._resets = 0
        """How often it was reset since `_on_reset` was told of it. Guarded by `_lock`."""
        self._on_reset: Callable[[int], Any] | None = None
        self._jump_handle: JumpHandle | None = None
        if self._ros_clock is not None:
            self._jump_handle = self._ros_clock.create_jump_callback(
                ANY_JUMP, pre_callback=self._before_jump, post_callback=self._after_jump
            )
        self._before_jump_ns = self._last_ns

    def _is_simulated(self) -> bool:
        return self._ros_clock is not None and self._ros_clock.ros_time_is_active

    def _now_ns(self) -> int:
        return self._clock.now_ns() if self._is_simulated() else time.monotonic_ns()

    @property
    def callback(self) -> TimerCallback | None:
        """Called once a period; None: it only wakes the executor."""
        return self._callback

    @callback.setter
    def callback(self, callback: TimerCallback | None) -> None:
        self._info_parameter = info_parameter(callback)
        self._callback: Callable[..., Any] | None = callback

    @property
    def clock(self) -> Clock:
        """The clock of the period."""
        return self._clock

    @property
    def timer_period_ns(self) -> int:
        """The period [ns]. A new period applies after the next call, whose time is unchanged.

        Raises:
            InvalidHandle: the timer was destroyed, as by all methods below that programs call.
        """
        self._alive()
        return self._period_ns

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        period_ns = _checked_period(value)
        self._alive()
        self._period_ns = period_ns

    def is_ready(self) -> bool:
        """Return whether the callback is due."""
        self._alive()
        return self.has_next()

    def is_canceled(self) -> bool:
        """Return whether it was cancelled, or not started yet."""
        self._alive()
        return self._canceled

    def cancel(self) -> None:
        """Stop calling the callback, until `reset`."""
        self._alive()
        self._canceled = True

    def reset(self) -> None:
        """Begin a period now, also after `cancel`."""
        self._alive()
        with self._lock:
            self._last_ns = self._now_ns()
            self._next_ns = self._last_ns + self._period_ns
            self._canceled = False
            self._resets += 1
        self._post()
        self._tell_resets()

    def set_on_reset_callback(self, callback: Callable[[int], Any]) -> None:
        """Call a function with the number of resets, on the thread of each; now, if there were some before.

        rclpy's handle has this name.

        Args:
            callback: Called with a number above 0.

        Raises:
            TypeError: `callback` isn't callable.
        """
        self._alive()
        if not callable(callback):
            raise TypeError(f"a callback of resets must be callable, got {callback!r}")
        self._on_reset = callback
        self._tell_resets()

    def clear_on_reset_callback(self) -> None:
        """Undo `set_on_reset_callback`."""
        self._on_reset = None

    def _tell_resets(self) -> None:
        callback = self._on_reset
        if callback is None:
            return
        with self._lock:
            count, self._resets = self._resets, 0
        if count:
            callback(count)

    def time_since_last_call(self) -> int:
        """Return the time since the last call, or since start or reset [ns]."""
        self._alive()
        return self._now_ns() - self._last_ns

    def time_until_next_call(self) -> int | None:
        """Return the time until the next call [ns], negative if it is late; None if cancelled."""
        self._alive()
        return None if self._canceled else self._next_ns - self._now_ns()

    def destroy(self) -> None:
        """Stop calling the callback, permanently. The node no longer has it then."""
        self._canceled = True
        self._end()
        if self._jump_handle is not None:
            self._jump_handle.unregister()
            self._jump_handle = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.destroy()

    def attach(self, queue: ReadyQueue, token: int) -> None:
        """Post `token` when the time of the next call has changed."""
        self._queue, self._token = queue, token
        queue.post(token)

    def deadline_ns(self) -> int | None:
        """Return when the next call is due, by the steady clock; None with simulated time, and if cancelled."""
        return None if self._canceled or self._is_simulated() else self._next_ns

    def becomes_ready(self) -> bool:
        """Return whether the period has ended, for a wait set."""
        return self.has_next()

    def has_next(self) -> bool:
        """Return whether the callback is due; the next period doesn't begin before `take`."""
        return not self._canceled and self._now_ns() >= self._next_ns

    def take(self) -> Any:
        """Begin the next period, and return what `run` needs of the call, if the callback is due; otherwise None."""
        is_simulated = self._is_simulated()
        with self._lock:
            now_ns = self._clock.now_ns() if is_simulated else time.monotonic_ns()
            if self._canceled or now_ns < self._next_ns:
                return None
            # The next period begins when this call was due, so that late calls don't add up to a lower frequency. Calls
            # that were missed by a whole period are left out, and the rhythm is kept.
            late_ns = now_ns - self._next_ns
            self._last_ns = now_ns
            self._next_ns += self._period_ns
            if self._next_ns < now_ns:
                self._next_ns = now_ns if not self._period_ns else self._skip_missed(now_ns)
        # Without a deadline by the steady clock, the executor looks again only after a post; the clock may have jumped
        # over more than one period.
        if is_simulated:
            self._post_if_ready()
        return True if self._info_parameter is None else self._info(late_ns)

    def _info(self, late_ns: int) -> TimerInfo:
        # The period is measured by the steady clock, whose zero means nothing to the program.
        now_ns = self._clock.now_ns()
        return TimerInfo(
            expected_call_time=max(0, now_ns - late_ns),
            actual_call_time=max(0, now_ns),
            clock_type=self._clock.clock_type,
        )

    def run(self, taken: Any) -> Any:
        """Call the callback."""
        if self._callback is None:
            return None
        if self._info_parameter is None:
            return self._callback()
        return self._callback(**{self._info_parameter: taken})

    def _skip_missed(self, now_ns: int) -> int:
        missed = 1 + (now_ns - self._next_ns) // self._period_ns
        return self._next_ns + missed * self._period_ns

    def _post_if_ready(self) -> None:
        if self.has_next():
            self._post()

    def _before_jump(self) -> None:
        self._before_jump_ns = self._now_ns()

    def _after_jump(self, jump: TimeJump) -> None:
        with self._lock:
            now_ns = self._now_ns()
            if jump.clock_change in SOURCE_CHANGES:
                # The remaining time of the period stays the same on the new source.
                shift_ns = now_ns - self._before_jump_ns
                self._last_ns += shift_ns
                self._next_ns += shift_ns
            elif now_ns < self._last_ns:
                # The time was set back, as when a recording begins again. The next call would be far away: begin anew.
                self._last_ns = now_ns
                self._next_ns = now_ns + self._period_ns
            elif now_ns < self._next_ns:  # the usual step of simulated time, within the period
                return
        self._post()


def _checked_period(period_ns: int) -> int:
    try:
        checked_ns = int(period_ns)
    except OverflowError:  # infinite
        checked_ns = INT64_MAX + 1
    if checked_ns < 0:
        raise ValueError(f"timer period must be non-negative, not {checked_ns} ns")
    if checked_ns > INT64_MAX:
        raise ValueError(f"a timer {too_long('period', period_ns)}")
    return checked_ns


class Rate:
    """Keeps a loop at a frequency: `sleep` returns once a period.

    Another thread must spin the node of its timer. `Node.create_rate` creates one.
    """

    def __init__(self, timer: Timer, *, context: Context) -> None:
        self._timer = timer
        self._context = context
        self._ticked = threading.Event()
        self._destroyed = False
        timer.callback = self._ticked.set
        context.add_shutdown_hook(self._ticked.set)

    def __repr__(self) -> str:
        return ros_repr(self)

    @property
    def timer(self) -> Timer:
        """The timer that it waits for."""
        return self._timer

    def sleep(self) -> None:
        """Wait for the next period.

        Raises:
            ROSInterruptException: the context is shut down, before or during the wait.
            ForkedProcessError: this process is a fork of the one that created the rate.
            RuntimeError: the rate was destroyed before; a wait during which it is destroyed just ends.
        """
        if self._destroyed:
            raise RuntimeError("Rate cannot sleep because it has been destroyed")
        if not self._context.ok():
            self._context.check_not_from_parent_process("cannot sleep")
            raise ROSInterruptException
        self._ticked.wait()
        self._ticked.clear()
        if self._destroyed:
            self._ticked.set()  # as below
            return
        if not self._context.ok():
            self._ticked.set()  # `clear` has undone that of the shutdown, for which another thread may wait, too
            raise ROSInterruptException

    def destroy(self) -> None:
        """Destroy the timer; each `sleep` that waits for it returns."""
        self._destroyed = True
        self._context.remove_shutdown_hook(self._ticked.set)
        self._timer.destroy()
        self._ticked.set()
