"""Parameters."""

from tfloom.node.parameters.parameter import *
from tfloom.node.parameters.parameter import __all__
