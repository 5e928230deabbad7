"""The base class of the events that report on a process."""

from tfloom.launch.event import Event as Event
from tfloom.launch.events.process.running_process_event import RunningProcessEvent as RunningProcessEvent
