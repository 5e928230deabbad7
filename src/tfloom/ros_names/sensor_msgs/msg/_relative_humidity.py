"""The classes of sensor_msgs/msg/RelativeHumidity, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import RelativeHumidity as RelativeHumidity
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RelativeHumidity

__all__ = ["Metaclass_RelativeHumidity", "RelativeHumidity"]
