"""The classes of sensor_msgs/msg/MultiDOFJointState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import MultiDOFJointState as MultiDOFJointState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MultiDOFJointState

__all__ = ["Metaclass_MultiDOFJointState", "MultiDOFJointState"]
