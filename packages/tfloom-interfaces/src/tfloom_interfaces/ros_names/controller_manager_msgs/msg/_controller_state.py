"""The classes of controller_manager_msgs/msg/ControllerState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.msg import ControllerState as ControllerState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ControllerState

__all__ = ["Metaclass_ControllerState", "ControllerState"]
