"""The classes of object_recognition_msgs/msg/TableArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.object_recognition_msgs.msg import TableArray as TableArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TableArray

__all__ = ["Metaclass_TableArray", "TableArray"]
