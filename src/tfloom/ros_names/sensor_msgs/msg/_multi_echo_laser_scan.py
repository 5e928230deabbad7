"""The classes of sensor_msgs/msg/MultiEchoLaserScan, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import MultiEchoLaserScan as MultiEchoLaserScan
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiEchoLaserScan

__all__ = ["Metaclass_MultiEchoLaserScan", "MultiEchoLaserScan"]
