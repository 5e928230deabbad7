"""Clocks."""

from tfloom.node.clock.clock import *
from tfloom.node.clock.clock import __all__
