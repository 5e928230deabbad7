"""The start of a process."""

from tfloom.launch.events.process.process_started import ProcessStarted as ProcessStarted
from tfloom.launch.events.process.running_process_event import RunningProcessEvent as RunningProcessEvent
