"""The events executor, which runs callbacks in the order of their events."""

from tfloom.node.executing.events_executor import *
from tfloom.node.executing.events_executor import __all__
