"""The classes of std_msgs/msg/Float32, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Float32 as Float32
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Float32

__all__ = ["Metaclass_Float32", "Float32"]
