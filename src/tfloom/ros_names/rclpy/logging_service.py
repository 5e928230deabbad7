"""The services that read and set logger levels."""

from tfloom.node.builtin.logging_service import *
from tfloom.node.builtin.logging_service import __all__
