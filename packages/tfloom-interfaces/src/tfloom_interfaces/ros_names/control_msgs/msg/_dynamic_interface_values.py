"""The classes of control_msgs/msg/DynamicInterfaceValues, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import DynamicInterfaceValues as DynamicInterfaceValues
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DynamicInterfaceValues

__all__ = ["Metaclass_DynamicInterfaceValues", "DynamicInterfaceValues"]
