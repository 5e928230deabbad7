"""The classes of sensor_msgs/msg/PointCloud, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import PointCloud as PointCloud
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointCloud

__all__ = ["Metaclass_PointCloud", "PointCloud"]
