"""The classes of controller_manager_msgs/msg/HardwareComponentState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.msg import HardwareComponentState as HardwareComponentState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_HardwareComponentState

__all__ = ["Metaclass_HardwareComponentState", "HardwareComponentState"]
