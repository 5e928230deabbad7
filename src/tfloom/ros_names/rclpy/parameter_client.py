"""Parameters of other nodes."""

from tfloom.node.parameter_client import *
from tfloom.node.parameter_client import __all__
