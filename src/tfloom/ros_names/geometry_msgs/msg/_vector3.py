"""The classes of geometry_msgs/msg/Vector3, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Vector3 as Vector3
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Vector3

__all__ = ["Metaclass_Vector3", "Vector3"]
