"""The default context, and what goes by it."""

from tfloom.node.context.utilities import *
from tfloom.node.context.utilities import __all__
