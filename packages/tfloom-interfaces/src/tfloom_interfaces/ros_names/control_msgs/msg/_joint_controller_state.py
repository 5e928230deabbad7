"""The classes of control_msgs/msg/JointControllerState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import JointControllerState as JointControllerState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointControllerState

__all__ = ["Metaclass_JointControllerState", "JointControllerState"]
