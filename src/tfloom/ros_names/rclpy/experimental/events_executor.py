"""The events executor."""

from tfloom.node.experimental.events_executor import *
from tfloom.node.experimental.events_executor import __all__
