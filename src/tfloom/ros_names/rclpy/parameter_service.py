"""The services of parameters."""

from tfloom.node.parameter_service import *
from tfloom.node.parameter_service import __all__
