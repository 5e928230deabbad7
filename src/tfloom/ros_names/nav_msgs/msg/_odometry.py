"""The classes of nav_msgs/msg/Odometry, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.nav_msgs.msg import Odometry as Odometry
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Odometry

__all__ = ["Metaclass_Odometry", "Odometry"]
