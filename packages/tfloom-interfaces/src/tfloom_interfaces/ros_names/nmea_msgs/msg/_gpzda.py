"""The classes of nmea_msgs/msg/Gpzda, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Gpzda as Gpzda
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gpzda

__all__ = ["Metaclass_Gpzda", "Gpzda"]
