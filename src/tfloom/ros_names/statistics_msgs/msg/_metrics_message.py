"""The classes of statistics_msgs/msg/MetricsMessage, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.statistics_msgs.msg import MetricsMessage as MetricsMessage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MetricsMessage

__all__ = ["Metaclass_MetricsMessage", "MetricsMessage"]
