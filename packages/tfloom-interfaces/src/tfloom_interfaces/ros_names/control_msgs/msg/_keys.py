"""The classes of control_msgs/msg/Keys, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import Keys as Keys
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Keys

__all__ = ["Metaclass_Keys", "Keys"]
