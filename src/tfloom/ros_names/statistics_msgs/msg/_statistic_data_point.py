"""The classes of statistics_msgs/msg/StatisticDataPoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.statistics_msgs.msg import StatisticDataPoint as StatisticDataPoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_StatisticDataPoint

__all__ = ["Metaclass_StatisticDataPoint", "StatisticDataPoint"]
