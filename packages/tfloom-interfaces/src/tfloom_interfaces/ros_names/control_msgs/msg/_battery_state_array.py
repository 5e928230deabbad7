"""The classes of control_msgs/msg/BatteryStateArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import BatteryStateArray as BatteryStateArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BatteryStateArray

__all__ = ["Metaclass_BatteryStateArray", "BatteryStateArray"]
