"""The classes of std_msgs/msg/Float64, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Float64 as Float64
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Float64

__all__ = ["Metaclass_Float64", "Float64"]
