"""The classes of geometry_msgs/msg/AccelWithCovariance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import AccelWithCovariance as AccelWithCovariance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AccelWithCovariance

__all__ = ["Metaclass_AccelWithCovariance", "AccelWithCovariance"]
