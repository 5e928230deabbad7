"""The severities of log records."""

from tfloom.node.log.logging_severity import *
from tfloom.node.log.logging_severity import __all__
