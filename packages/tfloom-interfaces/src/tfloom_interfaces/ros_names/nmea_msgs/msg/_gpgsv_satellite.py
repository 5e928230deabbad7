"""The classes of nmea_msgs/msg/GpgsvSatellite, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import GpgsvSatellite as GpgsvSatellite
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GpgsvSatellite

__all__ = ["Metaclass_GpgsvSatellite", "GpgsvSatellite"]
