"""The classes of turtlesim/msg/Pose, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.turtlesim.msg import Pose as Pose
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Pose

__all__ = ["Metaclass_Pose", "Pose"]
