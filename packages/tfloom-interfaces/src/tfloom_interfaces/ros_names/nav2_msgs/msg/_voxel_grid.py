"""The classes of nav2_msgs/msg/VoxelGrid, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import VoxelGrid as VoxelGrid
from tfloom.rosidl.class_modules import Metaclass as Metaclass_VoxelGrid

__all__ = ["Metaclass_VoxelGrid", "VoxelGrid"]
