"""Points in time."""

from tfloom.node.values.time import *
from tfloom.node.values.time import __all__
