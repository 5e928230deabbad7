"""The classes of geometry_msgs/msg/Inertia, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Inertia as Inertia
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Inertia

__all__ = ["Metaclass_Inertia", "Inertia"]
