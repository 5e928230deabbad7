"""One life of the library in a process."""

from tfloom.node.context import *
from tfloom.node.context import __all__
