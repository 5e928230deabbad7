"""The classes of type_description_interfaces/msg/Field, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.type_description_interfaces.msg import Field as Field
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Field

__all__ = ["Metaclass_Field", "Field"]
