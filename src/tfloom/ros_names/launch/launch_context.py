"""The state of a launch: its events and handlers, variables, launch configurations and environment."""

from typing import TYPE_CHECKING

from tfloom.launch.event import Event as Event
from tfloom.launch.launch_context import LaunchContext as LaunchContext

if TYPE_CHECKING:
    from tfloom.launch.event_handler import BaseEventHandler as BaseEventHandler
    from tfloom.launch.substitution import Substitution as Substitution
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        BaseEventHandler="tfloom.launch.event_handler",
        Substitution="tfloom.launch.substitution",
    )
