"""The classes of geometry_msgs/msg/TwistWithCovariance, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import TwistWithCovariance as TwistWithCovariance
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TwistWithCovariance

__all__ = ["Metaclass_TwistWithCovariance", "TwistWithCovariance"]
