"""The classes of sensor_msgs/msg/Temperature, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import Temperature as Temperature
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Temperature

__all__ = ["Metaclass_Temperature", "Temperature"]
