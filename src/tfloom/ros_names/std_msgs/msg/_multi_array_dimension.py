"""The classes of std_msgs/msg/MultiArrayDimension, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import MultiArrayDimension as MultiArrayDimension
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiArrayDimension

__all__ = ["Metaclass_MultiArrayDimension", "MultiArrayDimension"]
