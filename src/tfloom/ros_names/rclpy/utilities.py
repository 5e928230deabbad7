"""The default context, and what goes by it."""

from tfloom.node.utilities import *
from tfloom.node.utilities import __all__
