"""The classes of control_msgs/msg/JointTolerance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import JointTolerance as JointTolerance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointTolerance

__all__ = ["Metaclass_JointTolerance", "JointTolerance"]
