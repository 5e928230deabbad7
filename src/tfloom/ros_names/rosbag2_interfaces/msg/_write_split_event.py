"""The classes of rosbag2_interfaces/msg/WriteSplitEvent, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.rosbag2_interfaces.msg import WriteSplitEvent as WriteSplitEvent
from tfloom.rosidl.class_modules import Metaclass as Metaclass_WriteSplitEvent

__all__ = ["Metaclass_WriteSplitEvent", "WriteSplitEvent"]
