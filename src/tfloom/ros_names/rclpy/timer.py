"""Timers and rates."""

from typing import TYPE_CHECKING

from tfloom.node.clock.clock import Clock as Clock
from tfloom.node.context.context import Context as Context
from tfloom.node.context.utilities import get_default_context as get_default_context
from tfloom.node.executing.timer import *
from tfloom.node.values.exceptions import InvalidHandle as InvalidHandle
from tfloom.node.values.exceptions import ROSInterruptException as ROSInterruptException

if TYPE_CHECKING:
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
    )
