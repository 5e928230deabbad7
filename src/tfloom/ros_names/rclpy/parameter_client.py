"""Parameters of other nodes."""

from tfloom.node.builtin.parameter_client import *
from tfloom.node.builtin.parameter_client import __all__
