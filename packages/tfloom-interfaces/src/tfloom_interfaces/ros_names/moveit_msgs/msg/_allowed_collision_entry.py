"""The classes of moveit_msgs/msg/AllowedCollisionEntry, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import AllowedCollisionEntry as AllowedCollisionEntry
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AllowedCollisionEntry

__all__ = ["Metaclass_AllowedCollisionEntry", "AllowedCollisionEntry"]
