"""The classes of sensor_msgs/msg/JointState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import JointState as JointState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JointState

__all__ = ["Metaclass_JointState", "JointState"]
