"""The receiving end of a topic."""

from tfloom.node.endpoints.subscription import *
from tfloom.node.endpoints.subscription import __all__
