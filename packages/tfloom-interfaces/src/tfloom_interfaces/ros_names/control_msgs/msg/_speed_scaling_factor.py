"""The classes of control_msgs/msg/SpeedScalingFactor, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import SpeedScalingFactor as SpeedScalingFactor
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SpeedScalingFactor

__all__ = ["Metaclass_SpeedScalingFactor", "SpeedScalingFactor"]
