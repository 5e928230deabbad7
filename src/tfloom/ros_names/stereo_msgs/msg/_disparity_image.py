"""The classes of stereo_msgs/msg/DisparityImage, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.stereo_msgs.msg import DisparityImage as DisparityImage
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DisparityImage

__all__ = ["Metaclass_DisparityImage", "DisparityImage"]
