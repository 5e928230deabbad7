"""The classes of sensor_msgs/msg/BatteryState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import BatteryState as BatteryState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BatteryState

__all__ = ["Metaclass_BatteryState", "BatteryState"]
