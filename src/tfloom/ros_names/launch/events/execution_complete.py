"""The end of an action."""

from typing import TYPE_CHECKING

from tfloom.launch.event import Event as Event
from tfloom.launch.events.execution_complete import ExecutionComplete as ExecutionComplete

if TYPE_CHECKING:
    from tfloom.launch.action import Action as Action
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Action="tfloom.launch.action",
    )
