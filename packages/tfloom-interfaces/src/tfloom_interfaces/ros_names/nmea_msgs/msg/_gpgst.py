"""The classes of nmea_msgs/msg/Gpgst, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Gpgst as Gpgst
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Gpgst

__all__ = ["Metaclass_Gpgst", "Gpgst"]
