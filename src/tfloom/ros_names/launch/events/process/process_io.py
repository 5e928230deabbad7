"""Input and output of a process."""

from tfloom.launch.events.process.process_io import ProcessIO as ProcessIO
from tfloom.launch.events.process.running_process_event import RunningProcessEvent as RunningProcessEvent
