"""The sending end of a topic."""

from tfloom.node.publisher import *
from tfloom.node.publisher import __all__
