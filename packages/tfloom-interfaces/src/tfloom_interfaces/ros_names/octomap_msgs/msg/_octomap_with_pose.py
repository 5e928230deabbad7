"""The classes of octomap_msgs/msg/OctomapWithPose, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.octomap_msgs.msg import OctomapWithPose as OctomapWithPose
from tfloom.rosidl.class_modules import Metaclass as Metaclass_OctomapWithPose

__all__ = ["Metaclass_OctomapWithPose", "OctomapWithPose"]
