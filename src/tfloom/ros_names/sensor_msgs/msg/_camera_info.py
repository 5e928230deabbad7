"""The classes of sensor_msgs/msg/CameraInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import CameraInfo as CameraInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CameraInfo

__all__ = ["Metaclass_CameraInfo", "CameraInfo"]
