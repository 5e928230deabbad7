"""The classes of control_msgs/msg/MultiDOFCommand, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import MultiDOFCommand as MultiDOFCommand
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiDOFCommand

__all__ = ["Metaclass_MultiDOFCommand", "MultiDOFCommand"]
