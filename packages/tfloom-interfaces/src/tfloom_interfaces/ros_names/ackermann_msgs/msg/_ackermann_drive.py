"""The classes of ackermann_msgs/msg/AckermannDrive, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.ackermann_msgs.msg import AckermannDrive as AckermannDrive
from tfloom.rosidl.class_modules import Metaclass as Metaclass_AckermannDrive

__all__ = ["Metaclass_AckermannDrive", "AckermannDrive"]
