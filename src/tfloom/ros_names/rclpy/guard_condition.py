"""Guard conditions: callbacks that the program triggers."""

from tfloom.node.executing.guard_condition import *
from tfloom.node.executing.guard_condition import __all__
