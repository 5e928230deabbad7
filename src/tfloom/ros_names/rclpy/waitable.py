"""What programs write to have an executor wait for something of their own."""

from tfloom.node.executing.waitable import *
from tfloom.node.executing.waitable import __all__
