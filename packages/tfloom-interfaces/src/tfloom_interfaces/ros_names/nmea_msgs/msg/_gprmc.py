"""The classes of nmea_msgs/msg/Gprmc, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Gprmc as Gprmc
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gprmc

__all__ = ["Metaclass_Gprmc", "Gprmc"]
