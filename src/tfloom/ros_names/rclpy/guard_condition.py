"""A callback that a program triggers itself."""

from tfloom.node.guard_condition import *
from tfloom.node.guard_condition import __all__
