"""Handler of what processes read and write."""

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handlers.on_action_event_base import OnActionEventBase as OnActionEventBase
from tfloom.launch.event_handlers.on_process_io import OnProcessIO as OnProcessIO
from tfloom.launch.events.process.process_io import ProcessIO as ProcessIO
from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
