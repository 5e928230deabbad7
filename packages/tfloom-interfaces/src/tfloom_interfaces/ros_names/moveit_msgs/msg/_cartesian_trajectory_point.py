"""The classes of moveit_msgs/msg/CartesianTrajectoryPoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import CartesianTrajectoryPoint as CartesianTrajectoryPoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CartesianTrajectoryPoint

__all__ = ["Metaclass_CartesianTrajectoryPoint", "CartesianTrajectoryPoint"]
