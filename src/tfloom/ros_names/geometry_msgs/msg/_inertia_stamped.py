"""The classes of geometry_msgs/msg/InertiaStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import InertiaStamped as InertiaStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_InertiaStamped

__all__ = ["Metaclass_InertiaStamped", "InertiaStamped"]
