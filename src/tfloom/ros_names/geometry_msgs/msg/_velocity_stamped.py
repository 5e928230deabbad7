"""The classes of geometry_msgs/msg/VelocityStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import VelocityStamped as VelocityStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_VelocityStamped

__all__ = ["Metaclass_VelocityStamped", "VelocityStamped"]
