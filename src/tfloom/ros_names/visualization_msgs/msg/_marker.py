"""The classes of visualization_msgs/msg/Marker, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import Marker as Marker
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Marker

__all__ = ["Metaclass_Marker", "Marker"]
