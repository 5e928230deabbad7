"""The classes of vision_msgs/msg/VisionClass, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import VisionClass as VisionClass
from tfloom.rosidl.class_modules import Metaclass as Metaclass_VisionClass

__all__ = ["Metaclass_VisionClass", "VisionClass"]
