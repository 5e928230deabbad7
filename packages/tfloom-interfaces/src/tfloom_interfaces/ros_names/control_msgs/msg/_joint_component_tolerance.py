"""The classes of control_msgs/msg/JointComponentTolerance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import JointComponentTolerance as JointComponentTolerance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointComponentTolerance

__all__ = ["Metaclass_JointComponentTolerance", "JointComponentTolerance"]
