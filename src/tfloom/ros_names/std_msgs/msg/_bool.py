"""The classes of std_msgs/msg/Bool, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import Bool as Bool
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Bool

__all__ = ["Metaclass_Bool", "Bool"]
