"""Which callbacks may run at the same time."""

from tfloom.node.callback_groups import *
from tfloom.node.callback_groups import __all__
