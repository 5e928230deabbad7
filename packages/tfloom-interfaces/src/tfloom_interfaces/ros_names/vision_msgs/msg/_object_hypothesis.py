"""The classes of vision_msgs/msg/ObjectHypothesis, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.vision_msgs.msg import ObjectHypothesis as ObjectHypothesis
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ObjectHypothesis

__all__ = ["Metaclass_ObjectHypothesis", "ObjectHypothesis"]
