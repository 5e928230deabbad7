"""Durations."""

from tfloom.node.values.duration import *
from tfloom.node.values.duration import __all__
