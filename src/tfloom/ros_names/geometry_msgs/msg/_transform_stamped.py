"""The classes of geometry_msgs/msg/TransformStamped, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.geometry_msgs.msg import TransformStamped as TransformStamped
from tfloom.rosidl.class_modules import Metaclass as Metaclass_TransformStamped

__all__ = ["Metaclass_TransformStamped", "TransformStamped"]
