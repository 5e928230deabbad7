"""The classes of geometry_msgs/msg/PoseStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import PoseStamped as PoseStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PoseStamped

__all__ = ["Metaclass_PoseStamped", "PoseStamped"]
