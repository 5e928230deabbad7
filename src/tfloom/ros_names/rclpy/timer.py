"""Timers and rates."""

from tfloom.node.executing.timer import *
from tfloom.node.executing.timer import __all__
