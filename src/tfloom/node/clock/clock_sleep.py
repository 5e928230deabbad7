"""Sleeping by any clock, until a time, a shutdown, or a change of the clock's source."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from tfloom.node.clock.clock import Clock, ClockChange, JumpThreshold, ROSClock, TimeJump
from tfloom.node.values.constants import S_TO_NS
from tfloom.node.values.duration import Duration
from tfloom.node.values.exceptions import NotInitializedException

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.values.time import Time

__all__ = ["sleep_until"]

_ANY_JUMP = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1))
# The system's clock may be set while we sleep by it, and doesn't tell.
_LONGEST_SLICE_S = 1.0


def sleep_until(clock: Clock, until: Time, context: Context | None = None) -> bool:
    """Wait until `clock` shows `until`; see `Clock.sleep_until`."""
    from tfloom.node.context.utilities import get_default_context

    context = context or get_default_context()
    if not context.ok():
        raise NotInitializedException
    if until.clock_type != clock.clock_type:
        raise ValueError("until's clock type does not match this clock's type")
    woken = threading.Event()
    source_changed = False

    def on_jump(jump: TimeJump) -> None:
        nonlocal source_changed
        if jump.clock_change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            source_changed = True
        woken.set()

    with clock.create_jump_callback(_ANY_JUMP, post_callback=on_jump):
        context.add_shutdown_hook(woken.set)
        try:
            while context.ok() and not source_changed:
                left_ns = until.nanoseconds - clock.now_ns()
                if left_ns <= 0:
                    return True
                simulated = isinstance(clock, ROSClock) and clock.ros_time_is_active
                woken.wait(None if simulated else min(left_ns / S_TO_NS, _LONGEST_SLICE_S))
                woken.clear()
        finally:
            context.remove_shutdown_hook(woken.set)
    return False
