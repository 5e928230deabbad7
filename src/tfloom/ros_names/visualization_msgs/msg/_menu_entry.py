"""The classes of visualization_msgs/msg/MenuEntry, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import MenuEntry as MenuEntry
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MenuEntry

__all__ = ["Metaclass_MenuEntry", "MenuEntry"]
