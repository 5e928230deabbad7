"""Callbacks for parameter changes of any node."""

from tfloom.node.builtin.parameter_event_handler import *
from tfloom.node.builtin.parameter_event_handler import __all__
