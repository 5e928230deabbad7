"""Handlers for SIGINT (Ctrl-C) and SIGTERM."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.executing.signals import SignalHandlerGuardCondition as SignalHandlerGuardCondition
from tfloom.node.executing.signals import get_current_signal_handlers_options as get_current_signal_handlers_options
from tfloom.node.executing.signals import install_signal_handlers as install_signal_handlers
from tfloom.node.executing.signals import uninstall_signal_handlers as uninstall_signal_handlers

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.node.executing.guard_condition import GuardCondition as GuardCondition
    from tfloom.node.executing.signals import SignalHandlerOptions as SignalHandlerOptions
    from tfloom.node.values.exceptions import InvalidHandle as InvalidHandle
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        GuardCondition="tfloom.node.executing.guard_condition",
        InvalidHandle="tfloom.node.values.exceptions",
        SignalHandlerOptions="tfloom.node.executing.signals",
    )
