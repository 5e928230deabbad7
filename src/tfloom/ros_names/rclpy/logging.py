"""Loggers and their levels."""

from tfloom.node.log.logging import *
from tfloom.node.log.logging import __all__
