"""The classes of moveit_msgs/msg/LinkPadding, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import LinkPadding as LinkPadding
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LinkPadding

__all__ = ["Metaclass_LinkPadding", "LinkPadding"]
