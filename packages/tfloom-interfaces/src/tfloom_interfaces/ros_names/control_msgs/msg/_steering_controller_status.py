"""The classes of control_msgs/msg/SteeringControllerStatus, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import SteeringControllerStatus as SteeringControllerStatus
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SteeringControllerStatus

__all__ = ["Metaclass_SteeringControllerStatus", "SteeringControllerStatus"]
