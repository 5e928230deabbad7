"""The classes of visualization_msgs/msg/MarkerArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import MarkerArray as MarkerArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MarkerArray

__all__ = ["Metaclass_MarkerArray", "MarkerArray"]
