"""The classes of sensor_msgs/msg/Image, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import Image as Image
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Image

__all__ = ["Metaclass_Image", "Image"]
