"""The classes of moveit_msgs/msg/CartesianTrajectory, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import CartesianTrajectory as CartesianTrajectory
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CartesianTrajectory

__all__ = ["Metaclass_CartesianTrajectory", "CartesianTrajectory"]
