"""The classes of moveit_msgs/msg/ServoStatus, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import ServoStatus as ServoStatus
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ServoStatus

__all__ = ["Metaclass_ServoStatus", "ServoStatus"]
