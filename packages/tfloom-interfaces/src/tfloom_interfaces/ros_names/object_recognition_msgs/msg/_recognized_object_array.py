"""The classes of object_recognition_msgs/msg/RecognizedObjectArray, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.object_recognition_msgs.msg import RecognizedObjectArray as RecognizedObjectArray
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RecognizedObjectArray

__all__ = ["Metaclass_RecognizedObjectArray", "RecognizedObjectArray"]
