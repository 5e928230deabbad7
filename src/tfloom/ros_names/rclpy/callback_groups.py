"""Callback groups: which callbacks may run at the same time."""

from tfloom.node.executing.callback_groups import *
from tfloom.node.executing.callback_groups import __all__
