"""The classes of moveit_msgs/msg/WorkspaceParameters, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import WorkspaceParameters as WorkspaceParameters
from tfloom.rosidl.class_modules import Metaclass as Metaclass_WorkspaceParameters

__all__ = ["Metaclass_WorkspaceParameters", "WorkspaceParameters"]
