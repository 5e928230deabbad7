"""The classes of vision_msgs/msg/ObjectHypothesisWithPose, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import ObjectHypothesisWithPose as ObjectHypothesisWithPose
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ObjectHypothesisWithPose

__all__ = ["Metaclass_ObjectHypothesisWithPose", "ObjectHypothesisWithPose"]
