"""The classes of geometry_msgs/msg/PoseArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PoseArray as PoseArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PoseArray

__all__ = ["Metaclass_PoseArray", "PoseArray"]
