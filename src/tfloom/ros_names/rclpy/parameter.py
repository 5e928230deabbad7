"""Parameters."""

from tfloom.node.parameter import *
from tfloom.node.parameter import __all__
