"""Service servers."""

from tfloom.node.endpoints.service import *
from tfloom.node.endpoints.service import __all__
