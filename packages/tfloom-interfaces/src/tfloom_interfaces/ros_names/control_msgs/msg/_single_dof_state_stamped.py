"""The classes of control_msgs/msg/SingleDOFStateStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import SingleDOFStateStamped as SingleDOFStateStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SingleDOFStateStamped

__all__ = ["Metaclass_SingleDOFStateStamped", "SingleDOFStateStamped"]
