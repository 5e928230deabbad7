"""The classes of controller_manager_msgs/msg/HardwareInterface, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.msg import HardwareInterface as HardwareInterface
from tfloom.rosidl.class_modules import Metaclass as Metaclass_HardwareInterface

__all__ = ["Metaclass_HardwareInterface", "HardwareInterface"]
