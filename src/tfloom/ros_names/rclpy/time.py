"""Points in time."""

from tfloom.node.time import *
from tfloom.node.time import __all__
