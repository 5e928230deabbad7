"""The classes of nmea_msgs/msg/Gpgga, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Gpgga as Gpgga
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gpgga

__all__ = ["Metaclass_Gpgga", "Gpgga"]
