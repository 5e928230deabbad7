"""The classes of sensor_msgs/msg/Illuminance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import Illuminance as Illuminance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Illuminance

__all__ = ["Metaclass_Illuminance", "Illuminance"]
