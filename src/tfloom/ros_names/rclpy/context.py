"""One life of the library in a process."""

from tfloom.node.context.context import *
from tfloom.node.context.context import __all__
