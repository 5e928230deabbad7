"""The classes of map_msgs/msg/PointCloud2Update, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.map_msgs.msg import PointCloud2Update as PointCloud2Update
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointCloud2Update

__all__ = ["Metaclass_PointCloud2Update", "PointCloud2Update"]
