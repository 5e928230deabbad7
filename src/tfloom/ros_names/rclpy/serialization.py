"""Messages to bytes and back."""

from tfloom.node.serialization import *
from tfloom.node.serialization import __all__
