"""The default context, and the functions that use it."""

from tfloom.node.context.context import Context as Context
from tfloom.node.context.utilities import *
