"""Loggers and their levels."""

from tfloom.node.log.logging import *
from tfloom.node.log.rcutils_logger import RcutilsLogger as RcutilsLogger
