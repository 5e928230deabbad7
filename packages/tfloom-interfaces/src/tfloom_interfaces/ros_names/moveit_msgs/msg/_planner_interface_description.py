"""The classes of moveit_msgs/msg/PlannerInterfaceDescription, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PlannerInterfaceDescription as PlannerInterfaceDescription
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlannerInterfaceDescription

__all__ = ["Metaclass_PlannerInterfaceDescription", "PlannerInterfaceDescription"]
