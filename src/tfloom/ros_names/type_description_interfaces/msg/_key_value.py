"""The classes of type_description_interfaces/msg/KeyValue, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.type_description_interfaces.msg import KeyValue as KeyValue
from tfloom.rosidl.class_modules import Metaclass as Metaclass_KeyValue

__all__ = ["Metaclass_KeyValue", "KeyValue"]
