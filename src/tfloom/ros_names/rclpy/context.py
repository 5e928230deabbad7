"""Contexts: the state of the library from `init` to `shutdown`."""

from tfloom.node.context.context import *
from tfloom.node.context.context import __all__
