"""The classes of type_description_interfaces/msg/FieldType, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.type_description_interfaces.msg import FieldType as FieldType
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FieldType

__all__ = ["Metaclass_FieldType", "FieldType"]
