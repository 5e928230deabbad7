"""The classes of statistics_msgs/msg/StatisticDataType, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.statistics_msgs.msg import StatisticDataType as StatisticDataType
from tfloom.rosidl.class_modules import Metaclass as Metaclass_StatisticDataType

__all__ = ["Metaclass_StatisticDataType", "StatisticDataType"]
