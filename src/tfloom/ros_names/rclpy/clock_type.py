"""The kinds of clocks."""

from tfloom.node.values.clock_type import *
from tfloom.node.values.clock_type import __all__
