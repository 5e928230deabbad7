"""The classes of geometry_msgs/msg/Quaternion, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Quaternion as Quaternion
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Quaternion

__all__ = ["Metaclass_Quaternion", "Quaternion"]
