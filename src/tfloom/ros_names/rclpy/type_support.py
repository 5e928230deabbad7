"""Whether a class is a type that ROS knows."""

from tfloom.node.values.exceptions import NoTypeSupportImportedException as NoTypeSupportImportedException
from tfloom.node.values.type_support import *
