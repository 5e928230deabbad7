"""The classes of control_msgs/msg/JointJog, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import JointJog as JointJog
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointJog

__all__ = ["Metaclass_JointJog", "JointJog"]
