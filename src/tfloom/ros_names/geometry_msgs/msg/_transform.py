"""The classes of geometry_msgs/msg/Transform, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Transform as Transform
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Transform

__all__ = ["Metaclass_Transform", "Transform"]
