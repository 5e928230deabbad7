"""The classes of control_msgs/msg/MecanumDriveControllerState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import MecanumDriveControllerState as MecanumDriveControllerState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MecanumDriveControllerState

__all__ = ["Metaclass_MecanumDriveControllerState", "MecanumDriveControllerState"]
