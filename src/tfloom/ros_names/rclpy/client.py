"""Service clients."""

from tfloom.node.endpoints.client import *
from tfloom.node.endpoints.client import __all__
