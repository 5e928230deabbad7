"""Events of publishers and subscriptions."""

from tfloom.node.event_handler import *
from tfloom.node.event_handler import __all__
