"""The classes of lifecycle_msgs/msg/Transition, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.msg import Transition as Transition
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Transition

__all__ = ["Metaclass_Transition", "Transition"]
