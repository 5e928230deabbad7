"""Spans of time."""

from tfloom.node.duration import *
from tfloom.node.duration import __all__
