"""The classes of geometry_msgs/msg/Pose2D, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Pose2D as Pose2D
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pose2D

__all__ = ["Metaclass_Pose2D", "Pose2D"]
