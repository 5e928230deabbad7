"""The classes of moveit_msgs/msg/CartesianPoint, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import CartesianPoint as CartesianPoint
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CartesianPoint

__all__ = ["Metaclass_CartesianPoint", "CartesianPoint"]
