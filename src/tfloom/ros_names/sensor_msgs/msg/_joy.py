"""The classes of sensor_msgs/msg/Joy, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import Joy as Joy
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Joy

__all__ = ["Metaclass_Joy", "Joy"]
