"""The classes of vision_msgs/msg/VisionInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import VisionInfo as VisionInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_VisionInfo

__all__ = ["Metaclass_VisionInfo", "VisionInfo"]
