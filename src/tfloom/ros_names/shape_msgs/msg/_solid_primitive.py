"""The classes of shape_msgs/msg/SolidPrimitive, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.shape_msgs.msg import SolidPrimitive as SolidPrimitive
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SolidPrimitive

__all__ = ["Metaclass_SolidPrimitive", "SolidPrimitive"]
