"""The classes of sensor_msgs/msg/MagneticField, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import MagneticField as MagneticField
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MagneticField

__all__ = ["Metaclass_MagneticField", "MagneticField"]
