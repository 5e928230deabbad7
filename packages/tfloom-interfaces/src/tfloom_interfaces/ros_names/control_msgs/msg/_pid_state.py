"""The classes of control_msgs/msg/PidState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import PidState as PidState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PidState

__all__ = ["Metaclass_PidState", "PidState"]
