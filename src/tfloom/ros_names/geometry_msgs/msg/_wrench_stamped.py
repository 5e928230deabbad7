"""The classes of geometry_msgs/msg/WrenchStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import WrenchStamped as WrenchStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_WrenchStamped

__all__ = ["Metaclass_WrenchStamped", "WrenchStamped"]
