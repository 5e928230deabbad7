"""The event that requests a transition of lifecycle nodes."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.event import Event as Event
    from tfloom.launch.ros.events.lifecycle.change_state import ChangeState as ChangeState
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        ChangeState="tfloom.launch.ros.events.lifecycle.change_state",
        Event="tfloom.launch.event",
    )
