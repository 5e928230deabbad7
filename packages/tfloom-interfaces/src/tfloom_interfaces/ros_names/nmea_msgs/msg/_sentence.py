"""The classes of nmea_msgs/msg/Sentence, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nmea_msgs.msg import Sentence as Sentence
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Sentence

__all__ = ["Metaclass_Sentence", "Sentence"]
