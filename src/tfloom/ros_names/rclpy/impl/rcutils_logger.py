"""Loggers."""

from tfloom.node.rcutils_logger import *
from tfloom.node.rcutils_logger import __all__
