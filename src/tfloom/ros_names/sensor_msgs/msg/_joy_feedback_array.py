"""The classes of sensor_msgs/msg/JoyFeedbackArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import JoyFeedbackArray as JoyFeedbackArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JoyFeedbackArray

__all__ = ["Metaclass_JoyFeedbackArray", "JoyFeedbackArray"]
