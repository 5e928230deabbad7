"""The services of parameters."""

from tfloom.node.builtin.parameter_service import *
from tfloom.node.builtin.parameter_service import __all__
