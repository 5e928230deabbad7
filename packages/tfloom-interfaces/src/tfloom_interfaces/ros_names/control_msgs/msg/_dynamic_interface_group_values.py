"""The classes of control_msgs/msg/DynamicInterfaceGroupValues, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import DynamicInterfaceGroupValues as DynamicInterfaceGroupValues
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DynamicInterfaceGroupValues

__all__ = ["Metaclass_DynamicInterfaceGroupValues", "DynamicInterfaceGroupValues"]
