"""The classes of diagnostic_msgs/msg/KeyValue, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.diagnostic_msgs.msg import KeyValue as KeyValue
from tfloom.rosidl.class_modules import Metaclass as Metaclass_KeyValue

__all__ = ["Metaclass_KeyValue", "KeyValue"]
