"""The default context, and the functions that use it."""

from tfloom.node.context.utilities import *
from tfloom.node.context.utilities import __all__
