"""The classes of shape_msgs/msg/Mesh, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.shape_msgs.msg import Mesh as Mesh
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Mesh

__all__ = ["Metaclass_Mesh", "Mesh"]
