"""The classes of moveit_msgs/msg/BoundingVolume, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import BoundingVolume as BoundingVolume
from tfloom.rosidl.class_modules import Metaclass as Metaclass_BoundingVolume

__all__ = ["Metaclass_BoundingVolume", "BoundingVolume"]
