"""The classes of moveit_msgs/msg/MotionSequenceRequest, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import MotionSequenceRequest as MotionSequenceRequest
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionSequenceRequest

__all__ = ["Metaclass_MotionSequenceRequest", "MotionSequenceRequest"]
