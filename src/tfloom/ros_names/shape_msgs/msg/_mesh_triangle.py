"""The classes of shape_msgs/msg/MeshTriangle, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.shape_msgs.msg import MeshTriangle as MeshTriangle
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MeshTriangle

__all__ = ["Metaclass_MeshTriangle", "MeshTriangle"]
