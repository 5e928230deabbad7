"""The classes of object_recognition_msgs/msg/Table, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.object_recognition_msgs.msg import Table as Table
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Table

__all__ = ["Metaclass_Table", "Table"]
