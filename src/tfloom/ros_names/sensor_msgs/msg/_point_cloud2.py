"""The classes of sensor_msgs/msg/PointCloud2, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import PointCloud2 as PointCloud2
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointCloud2

__all__ = ["Metaclass_PointCloud2", "PointCloud2"]
