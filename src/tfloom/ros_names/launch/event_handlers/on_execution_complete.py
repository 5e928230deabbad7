"""Handler of the end of an action."""

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handlers.on_action_event_base import OnActionEventBase as OnActionEventBase
from tfloom.launch.event_handlers.on_execution_complete import OnExecutionComplete as OnExecutionComplete
from tfloom.launch.events.execution_complete import ExecutionComplete as ExecutionComplete
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
