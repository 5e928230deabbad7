"""The severities of log records."""

from tfloom.node.logging_severity import *
from tfloom.node.logging_severity import __all__
