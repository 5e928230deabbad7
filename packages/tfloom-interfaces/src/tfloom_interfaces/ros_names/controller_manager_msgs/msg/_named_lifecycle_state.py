"""The classes of controller_manager_msgs/msg/NamedLifecycleState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.controller_manager_msgs.msg import NamedLifecycleState as NamedLifecycleState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_NamedLifecycleState

__all__ = ["Metaclass_NamedLifecycleState", "NamedLifecycleState"]
