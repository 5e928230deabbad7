"""The classes of sensor_msgs/msg/NavSatFix, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import NavSatFix as NavSatFix
from tfloom.rosidl.class_modules import Metaclass as Metaclass_NavSatFix

__all__ = ["Metaclass_NavSatFix", "NavSatFix"]
