"""The classes of turtlesim/msg/Color, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.turtlesim.msg import Color as Color
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Color

__all__ = ["Metaclass_Color", "Color"]
