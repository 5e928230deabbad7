"""The classes of vision_msgs/msg/Detection3DArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import Detection3DArray as Detection3DArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Detection3DArray

__all__ = ["Metaclass_Detection3DArray", "Detection3DArray"]
