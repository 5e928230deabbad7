"""The classes of shape_msgs/msg/Plane, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.shape_msgs.msg import Plane as Plane
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Plane

__all__ = ["Metaclass_Plane", "Plane"]
