"""Clocks."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.clock.clock import Clock as Clock
from tfloom.node.clock.clock import JumpHandle as JumpHandle
from tfloom.node.clock.clock import ROSClock as ROSClock
from tfloom.node.clock.time_jump import ClockChange as ClockChange
from tfloom.node.clock.time_jump import JumpThreshold as JumpThreshold
from tfloom.node.clock.time_jump import TimeJump as TimeJump

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.clock.clock import JumpHandlePreCallbackType as JumpHandlePreCallbackType
    from tfloom.node.context.context import Context as Context
    from tfloom.node.context.utilities import get_default_context as get_default_context
    from tfloom.node.values.clock_type import ClockType as ClockType
    from tfloom.node.values.destroyable import DestroyableType as DestroyableType
    from tfloom.node.values.duration import Duration as Duration
    from tfloom.node.values.exceptions import NotInitializedException as NotInitializedException
    from tfloom.node.values.time import Time as Time
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ClockType="tfloom.node.values.clock_type",
        Context="tfloom.node.context.context",
        DestroyableType="tfloom.node.values.destroyable",
        Duration="tfloom.node.values.duration",
        JumpHandlePreCallbackType="tfloom.node.clock.clock",
        NotInitializedException="tfloom.node.values.exceptions",
        Time="tfloom.node.values.time",
        get_default_context="tfloom.node.context.utilities",
    )
