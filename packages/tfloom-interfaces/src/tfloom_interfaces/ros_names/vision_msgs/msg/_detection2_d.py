"""The classes of vision_msgs/msg/Detection2D, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import Detection2D as Detection2D
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Detection2D

__all__ = ["Metaclass_Detection2D", "Detection2D"]
