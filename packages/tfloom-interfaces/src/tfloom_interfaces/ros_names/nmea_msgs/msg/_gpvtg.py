"""The classes of nmea_msgs/msg/Gpvtg, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Gpvtg as Gpvtg
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gpvtg

__all__ = ["Metaclass_Gpvtg", "Gpvtg"]
