"""The classes of std_msgs/msg/ColorRGBA, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.std_msgs.msg import ColorRGBA as ColorRGBA
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ColorRGBA

__all__ = ["Metaclass_ColorRGBA", "ColorRGBA"]
