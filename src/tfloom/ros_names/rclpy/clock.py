"""Clocks."""

from typing import TYPE_CHECKING

from tfloom.node.clock.clock import Clock as Clock
from tfloom.node.clock.clock import JumpHandle as JumpHandle
from tfloom.node.clock.clock import JumpHandlePreCallbackType as JumpHandlePreCallbackType
from tfloom.node.clock.clock import ROSClock as ROSClock
from tfloom.node.clock.time_jump import ClockChange as ClockChange
from tfloom.node.clock.time_jump import JumpThreshold as JumpThreshold
from tfloom.node.clock.time_jump import TimeJump as TimeJump
from tfloom.node.context.context import Context as Context
from tfloom.node.context.utilities import get_default_context as get_default_context
from tfloom.node.values.clock_type import ClockType as ClockType
from tfloom.node.values.duration import Duration as Duration
from tfloom.node.values.exceptions import NotInitializedException as NotInitializedException
from tfloom.node.values.time import Time as Time

if TYPE_CHECKING:
    from tfloom.node.values.destroyable import DestroyableType as DestroyableType
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        DestroyableType="tfloom.node.values.destroyable",
    )
