"""The classes of lifecycle_msgs/msg/TransitionEvent, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.msg import TransitionEvent as TransitionEvent
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TransitionEvent

__all__ = ["Metaclass_TransitionEvent", "TransitionEvent"]
