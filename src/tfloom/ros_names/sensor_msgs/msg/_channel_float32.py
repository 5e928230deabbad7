"""The classes of sensor_msgs/msg/ChannelFloat32, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import ChannelFloat32 as ChannelFloat32
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ChannelFloat32

__all__ = ["Metaclass_ChannelFloat32", "ChannelFloat32"]
