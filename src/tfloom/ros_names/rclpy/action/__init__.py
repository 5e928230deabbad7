"""Actions."""

from tfloom.node.action import *
from tfloom.node.action import __all__
