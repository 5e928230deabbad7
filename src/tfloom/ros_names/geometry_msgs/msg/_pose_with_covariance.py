"""The classes of geometry_msgs/msg/PoseWithCovariance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PoseWithCovariance as PoseWithCovariance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PoseWithCovariance

__all__ = ["Metaclass_PoseWithCovariance", "PoseWithCovariance"]
