"""The classes of moveit_msgs/msg/MotionSequenceItem, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import MotionSequenceItem as MotionSequenceItem
from tfloom.rosidl.class_modules import Metaclass as Metaclass_MotionSequenceItem

__all__ = ["Metaclass_MotionSequenceItem", "MotionSequenceItem"]
