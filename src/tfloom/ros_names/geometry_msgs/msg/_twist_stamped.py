"""The classes of geometry_msgs/msg/TwistStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import TwistStamped as TwistStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TwistStamped

__all__ = ["Metaclass_TwistStamped", "TwistStamped"]
