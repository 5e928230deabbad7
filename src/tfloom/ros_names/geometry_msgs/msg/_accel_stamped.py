"""The classes of geometry_msgs/msg/AccelStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import AccelStamped as AccelStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AccelStamped

__all__ = ["Metaclass_AccelStamped", "AccelStamped"]
