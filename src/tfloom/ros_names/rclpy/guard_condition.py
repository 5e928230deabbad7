"""Guard conditions: callbacks that the program triggers."""

from tfloom.node.context.utilities import get_default_context as get_default_context
from tfloom.node.executing.guard_condition import *
