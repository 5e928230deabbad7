"""The classes of geometry_msgs/msg/QuaternionStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import QuaternionStamped as QuaternionStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_QuaternionStamped

__all__ = ["Metaclass_QuaternionStamped", "QuaternionStamped"]
