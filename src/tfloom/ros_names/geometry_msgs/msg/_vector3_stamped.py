"""The classes of geometry_msgs/msg/Vector3Stamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Vector3Stamped as Vector3Stamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Vector3Stamped

__all__ = ["Metaclass_Vector3Stamped", "Vector3Stamped"]
