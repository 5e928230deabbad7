"""The base class of the events that do something to a process."""

from tfloom.launch.event import Event as Event
from tfloom.launch.events.process.process_targeted_event import ProcessTargetedEvent as ProcessTargetedEvent
