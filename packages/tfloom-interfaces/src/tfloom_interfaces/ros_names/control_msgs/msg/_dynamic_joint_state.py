"""The classes of control_msgs/msg/DynamicJointState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.control_msgs.msg import DynamicJointState as DynamicJointState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_DynamicJointState

__all__ = ["Metaclass_DynamicJointState", "DynamicJointState"]
