"""The classes of vision_msgs/msg/LabelInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import LabelInfo as LabelInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LabelInfo

__all__ = ["Metaclass_LabelInfo", "LabelInfo"]
