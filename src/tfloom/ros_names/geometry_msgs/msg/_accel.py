"""The classes of geometry_msgs/msg/Accel, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import Accel as Accel
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Accel

__all__ = ["Metaclass_Accel", "Accel"]
