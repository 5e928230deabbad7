"""The classes of vision_msgs/msg/Classification, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import Classification as Classification
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Classification

__all__ = ["Metaclass_Classification", "Classification"]
