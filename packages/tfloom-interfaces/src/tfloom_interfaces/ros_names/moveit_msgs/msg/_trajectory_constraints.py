"""The classes of moveit_msgs/msg/TrajectoryConstraints, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import TrajectoryConstraints as TrajectoryConstraints
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TrajectoryConstraints

__all__ = ["Metaclass_TrajectoryConstraints", "TrajectoryConstraints"]
