"""The classes of rosbag2_interfaces/msg/ReadSplitEvent, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.msg import ReadSplitEvent as ReadSplitEvent
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ReadSplitEvent

__all__ = ["Metaclass_ReadSplitEvent", "ReadSplitEvent"]
