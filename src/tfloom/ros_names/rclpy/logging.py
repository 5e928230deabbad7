"""Loggers by name."""

from tfloom.node.logging import *
from tfloom.node.logging import __all__
