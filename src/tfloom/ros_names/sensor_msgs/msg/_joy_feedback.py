"""The classes of sensor_msgs/msg/JoyFeedback, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom.interfaces.sensor_msgs.msg import JoyFeedback as JoyFeedback
from tfloom.rosidl.class_modules import Metaclass as Metaclass_JoyFeedback

__all__ = ["Metaclass_JoyFeedback", "JoyFeedback"]
