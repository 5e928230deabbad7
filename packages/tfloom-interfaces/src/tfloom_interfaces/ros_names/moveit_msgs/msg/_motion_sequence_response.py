"""The classes of moveit_msgs/msg/MotionSequenceResponse, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import MotionSequenceResponse as MotionSequenceResponse
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionSequenceResponse

__all__ = ["Metaclass_MotionSequenceResponse", "MotionSequenceResponse"]
