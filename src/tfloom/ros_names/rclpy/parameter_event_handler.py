"""Callbacks for changes of parameters."""

from tfloom.node.parameter_event_handler import *
from tfloom.node.parameter_event_handler import __all__
