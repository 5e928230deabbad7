"""The classes of control_msgs/msg/MotionPrimitiveSequence, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import MotionPrimitiveSequence as MotionPrimitiveSequence
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionPrimitiveSequence

__all__ = ["Metaclass_MotionPrimitiveSequence", "MotionPrimitiveSequence"]
