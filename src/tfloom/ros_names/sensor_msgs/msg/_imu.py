"""The classes of sensor_msgs/msg/Imu, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import Imu as Imu
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Imu

__all__ = ["Metaclass_Imu", "Imu"]
