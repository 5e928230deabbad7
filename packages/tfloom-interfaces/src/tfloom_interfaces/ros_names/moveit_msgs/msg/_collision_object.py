"""The classes of moveit_msgs/msg/CollisionObject, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import CollisionObject as CollisionObject
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CollisionObject

__all__ = ["Metaclass_CollisionObject", "CollisionObject"]
