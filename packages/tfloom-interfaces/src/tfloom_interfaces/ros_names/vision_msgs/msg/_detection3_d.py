"""The classes of vision_msgs/msg/Detection3D, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import Detection3D as Detection3D
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Detection3D

__all__ = ["Metaclass_Detection3D", "Detection3D"]
