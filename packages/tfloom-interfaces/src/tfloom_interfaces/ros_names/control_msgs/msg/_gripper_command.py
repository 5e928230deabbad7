"""The classes of control_msgs/msg/GripperCommand, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import GripperCommand as GripperCommand
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GripperCommand

__all__ = ["Metaclass_GripperCommand", "GripperCommand"]
