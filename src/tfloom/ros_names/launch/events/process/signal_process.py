"""A signal to some processes."""

from typing import TYPE_CHECKING

from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent as ProcessTargetedEvent
from tfloom.launch.events.process.signal_process import SignalProcess as SignalProcess

if TYPE_CHECKING:
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
    )
