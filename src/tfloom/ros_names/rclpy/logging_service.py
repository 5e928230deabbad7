"""The services of loggers."""

from tfloom.node.builtin.logging_service import *
from tfloom.node.builtin.logging_service import __all__
