"""The classes of moveit_msgs/msg/DisplayTrajectory, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import DisplayTrajectory as DisplayTrajectory
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DisplayTrajectory

__all__ = ["Metaclass_DisplayTrajectory", "DisplayTrajectory"]
