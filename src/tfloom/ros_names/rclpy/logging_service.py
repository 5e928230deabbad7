"""The services of loggers."""

from tfloom.node.logging_service import *
from tfloom.node.logging_service import __all__
