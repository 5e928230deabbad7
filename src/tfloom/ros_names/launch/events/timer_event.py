"""The end of a timer's period."""

from tfloom.launch.event import Event as Event
from tfloom.launch.events.timer_event import TimerEvent as TimerEvent
