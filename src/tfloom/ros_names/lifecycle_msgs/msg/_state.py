"""The classes of lifecycle_msgs/msg/State, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.msg import State as State
from tfloom.rosidl.class_modules import Metaclass as Metaclass_State

__all__ = ["Metaclass_State", "State"]
