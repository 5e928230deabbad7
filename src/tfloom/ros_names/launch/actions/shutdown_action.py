"""End the launch."""

from typing import TYPE_CHECKING

from tfloom.launch.actions.emit_event import EmitEvent as EmitEvent
from tfloom.launch.actions.shutdown_action import Shutdown as Shutdown
from tfloom.launch.events.process.process_exited import ProcessExited as ProcessExited
from tfloom.launch.events.shutdown import Shutdown as ShutdownEvent
from tfloom.launch.frontend.entity import Entity as Entity
from tfloom.launch.frontend.expose import expose_action as expose_action
from tfloom.launch.launch_context import LaunchContext as LaunchContext

__all__ = [
    "EmitEvent",
    "Entity",
    "LaunchContext",
    "ProcessExited",
    "Shutdown",
    "ShutdownEvent",
    "expose_action",
]

if TYPE_CHECKING:
    from tfloom.launch.frontend.parser import Parser as Parser
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        Parser="tfloom.launch.frontend.parser",
    )
