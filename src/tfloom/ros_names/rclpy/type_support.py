"""Whether a class is a type that ROS knows."""

from tfloom.node.type_support import *
from tfloom.node.type_support import __all__
