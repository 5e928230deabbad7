"""The default context, and what goes by it."""

from tfloom.node.context.context import Context as Context
from tfloom.node.context.utilities import *
