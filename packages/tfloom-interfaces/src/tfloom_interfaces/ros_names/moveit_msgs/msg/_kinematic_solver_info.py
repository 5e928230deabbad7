"""The classes of moveit_msgs/msg/KinematicSolverInfo, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import KinematicSolverInfo as KinematicSolverInfo
from tfloom.rosidl.class_modules import Metaclass as Metaclass_KinematicSolverInfo

__all__ = ["Metaclass_KinematicSolverInfo", "KinematicSolverInfo"]
