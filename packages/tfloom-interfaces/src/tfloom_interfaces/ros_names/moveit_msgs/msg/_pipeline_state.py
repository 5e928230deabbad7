"""The classes of moveit_msgs/msg/PipelineState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PipelineState as PipelineState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PipelineState

__all__ = ["Metaclass_PipelineState", "PipelineState"]
