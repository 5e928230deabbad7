"""The classes of visualization_msgs/msg/InteractiveMarkerFeedback, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerFeedback as InteractiveMarkerFeedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InteractiveMarkerFeedback

__all__ = ["Metaclass_InteractiveMarkerFeedback", "InteractiveMarkerFeedback"]
