"""Events of publishers and subscriptions."""

from tfloom.node.executing.event_handler import *
from tfloom.node.executing.event_handler import __all__
