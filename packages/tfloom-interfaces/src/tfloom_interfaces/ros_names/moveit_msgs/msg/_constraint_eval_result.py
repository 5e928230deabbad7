"""The classes of moveit_msgs/msg/ConstraintEvalResult, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import ConstraintEvalResult as ConstraintEvalResult
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ConstraintEvalResult

__all__ = ["Metaclass_ConstraintEvalResult", "ConstraintEvalResult"]
