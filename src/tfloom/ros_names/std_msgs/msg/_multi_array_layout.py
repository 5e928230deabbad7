"""The classes of std_msgs/msg/MultiArrayLayout, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import MultiArrayLayout as MultiArrayLayout
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiArrayLayout

__all__ = ["Metaclass_MultiArrayLayout", "MultiArrayLayout"]
