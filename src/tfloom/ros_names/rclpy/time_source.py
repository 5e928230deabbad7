"""Simulated time."""

from tfloom.node.builtin.time_source import *
from tfloom.node.builtin.time_source import __all__
