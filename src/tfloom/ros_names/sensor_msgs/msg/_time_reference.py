"""The classes of sensor_msgs/msg/TimeReference, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import TimeReference as TimeReference
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TimeReference

__all__ = ["Metaclass_TimeReference", "TimeReference"]
