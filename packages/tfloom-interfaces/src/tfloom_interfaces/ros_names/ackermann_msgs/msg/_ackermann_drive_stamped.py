"""The classes of ackermann_msgs/msg/AckermannDriveStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.ackermann_msgs.msg import AckermannDriveStamped as AckermannDriveStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AckermannDriveStamped

__all__ = ["Metaclass_AckermannDriveStamped", "AckermannDriveStamped"]
