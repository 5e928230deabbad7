"""The classes of geometry_msgs/msg/TwistWithCovarianceStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import TwistWithCovarianceStamped as TwistWithCovarianceStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TwistWithCovarianceStamped

__all__ = ["Metaclass_TwistWithCovarianceStamped", "TwistWithCovarianceStamped"]
