"""The classes of moveit_msgs/msg/GenericTrajectory, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import GenericTrajectory as GenericTrajectory
from tfloom.rosidl.class_modules import Metaclass as Metaclass_GenericTrajectory

__all__ = ["Metaclass_GenericTrajectory", "GenericTrajectory"]
