"""The classes of moveit_msgs/msg/AttachedCollisionObject, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import AttachedCollisionObject as AttachedCollisionObject
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AttachedCollisionObject

__all__ = ["Metaclass_AttachedCollisionObject", "AttachedCollisionObject"]
