"""The classes of sensor_msgs/msg/FluidPressure, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import FluidPressure as FluidPressure
from tfloom.rosidl.class_modules import Metaclass as Metaclass_FluidPressure

__all__ = ["Metaclass_FluidPressure", "FluidPressure"]
