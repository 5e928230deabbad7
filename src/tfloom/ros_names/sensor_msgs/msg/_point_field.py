"""The classes of sensor_msgs/msg/PointField, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import PointField as PointField
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PointField

__all__ = ["Metaclass_PointField", "PointField"]
