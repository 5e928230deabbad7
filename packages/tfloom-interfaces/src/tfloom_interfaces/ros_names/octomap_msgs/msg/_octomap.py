"""The classes of octomap_msgs/msg/Octomap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.octomap_msgs.msg import Octomap as Octomap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Octomap

__all__ = ["Metaclass_Octomap", "Octomap"]
