"""Time: a point in time on one clock."""

from tfloom.node.values.time import *
from tfloom.node.values.time import __all__
