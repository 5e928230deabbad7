"""Handler of the end of a process."""

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handlers.on_action_event_base import OnActionEventBase as OnActionEventBase
from tfloom.launch.event_handlers.on_process_exit import OnProcessExit as OnProcessExit
from tfloom.launch.events.process.process_exited import ProcessExited as ProcessExited
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
