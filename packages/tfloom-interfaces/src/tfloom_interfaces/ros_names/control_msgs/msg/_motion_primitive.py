"""The classes of control_msgs/msg/MotionPrimitive, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import MotionPrimitive as MotionPrimitive
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionPrimitive

__all__ = ["Metaclass_MotionPrimitive", "MotionPrimitive"]
