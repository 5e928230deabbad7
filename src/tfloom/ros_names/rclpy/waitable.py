"""What programs write to have an executor wait for something of their own."""

from tfloom.node.waitable import *
from tfloom.node.waitable import __all__
