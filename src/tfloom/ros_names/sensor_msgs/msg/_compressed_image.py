"""The classes of sensor_msgs/msg/CompressedImage, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import CompressedImage as CompressedImage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CompressedImage

__all__ = ["Metaclass_CompressedImage", "CompressedImage"]
