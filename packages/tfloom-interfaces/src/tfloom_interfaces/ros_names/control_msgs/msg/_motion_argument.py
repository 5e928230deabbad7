"""The classes of control_msgs/msg/MotionArgument, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import MotionArgument as MotionArgument
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionArgument

__all__ = ["Metaclass_MotionArgument", "MotionArgument"]
