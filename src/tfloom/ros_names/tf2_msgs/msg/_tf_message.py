"""The classes of tf2_msgs/msg/TFMessage, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.tf2_msgs.msg import TFMessage as TFMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TFMessage

__all__ = ["Metaclass_TFMessage", "TFMessage"]
