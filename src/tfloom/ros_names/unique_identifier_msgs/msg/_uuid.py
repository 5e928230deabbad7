"""The classes of unique_identifier_msgs/msg/UUID, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.unique_identifier_msgs.msg import UUID as UUID
from tfloom.rosidl.class_modules import Metaclass as Metaclass_UUID

__all__ = ["Metaclass_UUID", "UUID"]
