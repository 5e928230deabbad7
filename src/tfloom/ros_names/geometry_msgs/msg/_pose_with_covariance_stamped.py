"""The classes of geometry_msgs/msg/PoseWithCovarianceStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PoseWithCovarianceStamped

__all__ = ["Metaclass_PoseWithCovarianceStamped", "PoseWithCovarianceStamped"]
