"""The classes of visualization_msgs/msg/InteractiveMarkerInit, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerInit as InteractiveMarkerInit
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InteractiveMarkerInit

__all__ = ["Metaclass_InteractiveMarkerInit", "InteractiveMarkerInit"]
