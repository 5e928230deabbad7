"""Simulated time."""

from tfloom.node.time_source import *
from tfloom.node.time_source import __all__
