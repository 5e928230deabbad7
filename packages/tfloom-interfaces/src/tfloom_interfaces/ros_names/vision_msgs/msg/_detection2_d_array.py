"""The classes of vision_msgs/msg/Detection2DArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import Detection2DArray as Detection2DArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Detection2DArray

__all__ = ["Metaclass_Detection2DArray", "Detection2DArray"]
