"""The classes of lifecycle_msgs/msg/TransitionDescription, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.lifecycle_msgs.msg import TransitionDescription as TransitionDescription
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TransitionDescription

__all__ = ["Metaclass_TransitionDescription", "TransitionDescription"]
