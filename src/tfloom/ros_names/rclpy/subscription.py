"""The receiving end of a topic."""

from tfloom.node.subscription import *
from tfloom.node.subscription import __all__
