"""The classes of visualization_msgs/msg/UVCoordinate, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import UVCoordinate as UVCoordinate
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UVCoordinate

__all__ = ["Metaclass_UVCoordinate", "UVCoordinate"]
