"""The classes of control_msgs/msg/InterfaceValue, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import InterfaceValue as InterfaceValue
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InterfaceValue

__all__ = ["Metaclass_InterfaceValue", "InterfaceValue"]
