"""Base class of a program's own waitables."""

from tfloom.node.executing.waitable import *
from tfloom.node.executing.waitable import __all__
