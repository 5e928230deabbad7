"""The base class of events."""

from tfloom.launch.event import Event as Event
