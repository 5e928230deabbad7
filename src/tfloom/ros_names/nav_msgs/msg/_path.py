"""The classes of nav_msgs/msg/Path, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.msg import Path as Path
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Path

__all__ = ["Metaclass_Path", "Path"]
