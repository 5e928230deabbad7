"""The classes of control_msgs/msg/MultiDOFStateStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import MultiDOFStateStamped as MultiDOFStateStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiDOFStateStamped

__all__ = ["Metaclass_MultiDOFStateStamped", "MultiDOFStateStamped"]
