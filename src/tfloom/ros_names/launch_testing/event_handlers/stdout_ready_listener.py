"""Actions that follow a line of output."""

from tfloom.launch.actions.execute_process import ExecuteProcess as ExecuteProcess
from tfloom.launch.event_handlers.on_process_io import OnProcessIO as OnProcessIO
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.testing.stdout_ready_listener import StdoutReadyListener as StdoutReadyListener
