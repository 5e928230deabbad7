"""The classes of sensor_msgs/msg/LaserEcho, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import LaserEcho as LaserEcho
from tfloom.rosidl.class_modules import Metaclass as Metaclass_LaserEcho

__all__ = ["Metaclass_LaserEcho", "LaserEcho"]
