"""A callback that a program triggers itself."""

from tfloom.node.executing.guard_condition import *
from tfloom.node.executing.guard_condition import __all__
