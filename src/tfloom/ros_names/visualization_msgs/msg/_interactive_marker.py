"""The classes of visualization_msgs/msg/InteractiveMarker, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarker as InteractiveMarker
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InteractiveMarker

__all__ = ["Metaclass_InteractiveMarker", "InteractiveMarker"]
