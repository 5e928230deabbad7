"""The classes of type_description_interfaces/msg/TypeSource, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.type_description_interfaces.msg import TypeSource as TypeSource
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TypeSource

__all__ = ["Metaclass_TypeSource", "TypeSource"]
