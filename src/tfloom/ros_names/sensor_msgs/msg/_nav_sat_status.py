"""The classes of sensor_msgs/msg/NavSatStatus, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import NavSatStatus as NavSatStatus
from tfloom.rosidl.class_modules import Metaclass as Metaclass_NavSatStatus

__all__ = ["Metaclass_NavSatStatus", "NavSatStatus"]
