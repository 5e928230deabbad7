"""The classes of visualization_msgs/msg/InteractiveMarkerControl, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerControl as InteractiveMarkerControl
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InteractiveMarkerControl

__all__ = ["Metaclass_InteractiveMarkerControl", "InteractiveMarkerControl"]
