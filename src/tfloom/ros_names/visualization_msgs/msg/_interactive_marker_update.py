"""The classes of visualization_msgs/msg/InteractiveMarkerUpdate, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerUpdate as InteractiveMarkerUpdate
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InteractiveMarkerUpdate

__all__ = ["Metaclass_InteractiveMarkerUpdate", "InteractiveMarkerUpdate"]
