"""The classes of geometry_msgs/msg/AccelWithCovarianceStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import AccelWithCovarianceStamped as AccelWithCovarianceStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AccelWithCovarianceStamped

__all__ = ["Metaclass_AccelWithCovarianceStamped", "AccelWithCovarianceStamped"]
