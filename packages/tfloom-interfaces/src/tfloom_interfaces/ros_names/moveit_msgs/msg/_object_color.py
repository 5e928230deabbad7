"""The classes of moveit_msgs/msg/ObjectColor, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import ObjectColor as ObjectColor
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ObjectColor

__all__ = ["Metaclass_ObjectColor", "ObjectColor"]
