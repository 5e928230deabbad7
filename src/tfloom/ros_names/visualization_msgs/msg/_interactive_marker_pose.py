"""The classes of visualization_msgs/msg/InteractiveMarkerPose, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import InteractiveMarkerPose as InteractiveMarkerPose
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InteractiveMarkerPose

__all__ = ["Metaclass_InteractiveMarkerPose", "InteractiveMarkerPose"]
