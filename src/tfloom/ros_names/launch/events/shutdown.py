"""The end of a launch."""

from tfloom.launch.event import Event as Event
from tfloom.launch.events.shutdown import Shutdown as Shutdown
