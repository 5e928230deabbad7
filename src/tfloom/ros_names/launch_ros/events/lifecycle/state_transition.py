"""The event of a lifecycle node's transition."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tfloom.launch.event import Event as Event
    from tfloom.launch.ros.events.lifecycle.state_transition import StateTransition as StateTransition
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Event="tfloom.launch.event",
        StateTransition="tfloom.launch.ros.events.lifecycle.state_transition",
    )
