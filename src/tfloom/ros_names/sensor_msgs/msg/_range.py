"""The classes of sensor_msgs/msg/Range, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import Range as Range
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Range

__all__ = ["Metaclass_Range", "Range"]
