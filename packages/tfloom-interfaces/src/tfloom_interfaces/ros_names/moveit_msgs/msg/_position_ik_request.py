"""The classes of moveit_msgs/msg/PositionIKRequest, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PositionIKRequest as PositionIKRequest
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PositionIKRequest

__all__ = ["Metaclass_PositionIKRequest", "PositionIKRequest"]
