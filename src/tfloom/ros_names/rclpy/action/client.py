"""Action clients."""

from tfloom.node.action.client import *
from tfloom.node.action.client import __all__
