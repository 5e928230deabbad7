"""Publishers."""

from tfloom.node.endpoints.publisher import *
from tfloom.node.endpoints.publisher import __all__
