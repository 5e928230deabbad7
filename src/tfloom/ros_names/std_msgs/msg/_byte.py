"""The classes of std_msgs/msg/Byte, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Byte as Byte
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Byte

__all__ = ["Metaclass_Byte", "Byte"]
