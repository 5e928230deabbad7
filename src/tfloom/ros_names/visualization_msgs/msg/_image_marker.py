"""The classes of visualization_msgs/msg/ImageMarker, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import ImageMarker as ImageMarker
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ImageMarker

__all__ = ["Metaclass_ImageMarker", "ImageMarker"]
