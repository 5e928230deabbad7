"""The classes of control_msgs/msg/VDA5050SafetyState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import VDA5050SafetyState as VDA5050SafetyState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_VDA5050SafetyState

__all__ = ["Metaclass_VDA5050SafetyState", "VDA5050SafetyState"]
