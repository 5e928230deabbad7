"""The classes of control_msgs/msg/SingleDOFState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import SingleDOFState as SingleDOFState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_SingleDOFState

__all__ = ["Metaclass_SingleDOFState", "SingleDOFState"]
