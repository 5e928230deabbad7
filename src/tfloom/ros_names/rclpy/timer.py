"""Timers and rates."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.timer import Rate as Rate
from tfloom.node.executing.timer import Timer as Timer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock as Clock
    from tfloom.node.context.context import Context as Context
    from tfloom.node.context.utilities import get_default_context as get_default_context
    from tfloom.node.executing.callback_groups import CallbackGroup as CallbackGroup
    from tfloom.node.values.exceptions import InvalidHandle as InvalidHandle
    from tfloom.node.values.exceptions import ROSInterruptException as ROSInterruptException
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        CallbackGroup="tfloom.node.executing.callback_groups",
        Clock="tfloom.node.clock.clock",
        Context="tfloom.node.context.context",
        InvalidHandle="tfloom.node.values.exceptions",
        ROSInterruptException="tfloom.node.values.exceptions",
        get_default_context="tfloom.node.context.utilities",
    )
