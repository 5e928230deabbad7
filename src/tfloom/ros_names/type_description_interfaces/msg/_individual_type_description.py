"""The classes of type_description_interfaces/msg/IndividualTypeDescription, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.type_description_interfaces.msg import IndividualTypeDescription as IndividualTypeDescription
from tfloom.rosidl.class_modules import Metaclass as Metaclass_IndividualTypeDescription

__all__ = ["Metaclass_IndividualTypeDescription", "IndividualTypeDescription"]
