"""The kinds of clocks."""

from tfloom.node.clock_type import *
from tfloom.node.clock_type import __all__
