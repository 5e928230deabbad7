"""The classes of moveit_msgs/msg/LinkScale, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import LinkScale as LinkScale
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LinkScale

__all__ = ["Metaclass_LinkScale", "LinkScale"]
