"""The classes of type_description_interfaces/msg/TypeDescription, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.type_description_interfaces.msg import TypeDescription as TypeDescription
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TypeDescription

__all__ = ["Metaclass_TypeDescription", "TypeDescription"]
