"""The events executor."""

from tfloom.node.executing.events_executor import *
from tfloom.node.executing.events_executor import __all__
