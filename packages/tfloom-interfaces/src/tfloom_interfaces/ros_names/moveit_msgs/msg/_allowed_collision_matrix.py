"""The classes of moveit_msgs/msg/AllowedCollisionMatrix, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import AllowedCollisionMatrix as AllowedCollisionMatrix
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AllowedCollisionMatrix

__all__ = ["Metaclass_AllowedCollisionMatrix", "AllowedCollisionMatrix"]
