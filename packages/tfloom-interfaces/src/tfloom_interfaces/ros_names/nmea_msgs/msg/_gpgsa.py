"""The classes of nmea_msgs/msg/Gpgsa, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Gpgsa as Gpgsa
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gpgsa

__all__ = ["Metaclass_Gpgsa", "Gpgsa"]
