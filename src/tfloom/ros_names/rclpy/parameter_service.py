"""The services that read and set a node's parameters."""

from tfloom.node.builtin.parameter_service import *
from tfloom.node.builtin.parameter_service import __all__
