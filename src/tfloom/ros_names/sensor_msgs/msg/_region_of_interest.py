"""The classes of sensor_msgs/msg/RegionOfInterest, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import RegionOfInterest as RegionOfInterest
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RegionOfInterest

__all__ = ["Metaclass_RegionOfInterest", "RegionOfInterest"]
