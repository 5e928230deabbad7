"""The classes of nmea_msgs/msg/Gpgsv, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Gpgsv as Gpgsv
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gpgsv

__all__ = ["Metaclass_Gpgsv", "Gpgsv"]
