"""Whether a class is a type that ROS knows."""

from tfloom.node.values.type_support import *
from tfloom.node.values.type_support import __all__
