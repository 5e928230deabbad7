"""Loggers."""

from tfloom.node.log.rcutils_logger import *
from tfloom.node.log.rcutils_logger import __all__
