"""The classes of nav2_msgs/msg/SpeedLimit, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import SpeedLimit as SpeedLimit
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SpeedLimit

__all__ = ["Metaclass_SpeedLimit", "SpeedLimit"]
