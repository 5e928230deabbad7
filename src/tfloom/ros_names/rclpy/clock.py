"""Clocks."""

from tfloom.node.clock import *
from tfloom.node.clock import __all__
