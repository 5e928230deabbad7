"""The classes of visualization_msgs/msg/MeshFile, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.visualization_msgs.msg import MeshFile as MeshFile
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MeshFile

__all__ = ["Metaclass_MeshFile", "MeshFile"]
