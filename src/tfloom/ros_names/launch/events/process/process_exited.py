"""The end of a process."""

from tfloom.launch.events.process.process_exited import ProcessExited as ProcessExited
from tfloom.launch.events.process.running_process_event import RunningProcessEvent as RunningProcessEvent
