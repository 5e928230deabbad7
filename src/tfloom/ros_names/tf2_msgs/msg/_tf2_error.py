"""The classes of tf2_msgs/msg/TF2Error, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.tf2_msgs.msg import TF2Error as TF2Error
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TF2Error

__all__ = ["Metaclass_TF2Error", "TF2Error"]
