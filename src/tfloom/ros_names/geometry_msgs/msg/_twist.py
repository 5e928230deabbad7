"""The classes of geometry_msgs/msg/Twist, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Twist as Twist
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Twist

__all__ = ["Metaclass_Twist", "Twist"]
