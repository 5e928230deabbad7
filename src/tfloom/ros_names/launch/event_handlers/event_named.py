"""A matcher by an event's name."""

from tfloom.launch.event import Event as Event
from tfloom.launch.event_handlers.event_named import event_named as event_named
