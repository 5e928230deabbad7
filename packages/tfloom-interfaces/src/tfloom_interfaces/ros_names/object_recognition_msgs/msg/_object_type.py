"""The classes of object_recognition_msgs/msg/ObjectType, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.object_recognition_msgs.msg import ObjectType as ObjectType
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ObjectType

__all__ = ["Metaclass_ObjectType", "ObjectType"]
