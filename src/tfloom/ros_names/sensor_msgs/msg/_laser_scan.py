"""The classes of sensor_msgs/msg/LaserScan, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import LaserScan as LaserScan
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LaserScan

__all__ = ["Metaclass_LaserScan", "LaserScan"]
