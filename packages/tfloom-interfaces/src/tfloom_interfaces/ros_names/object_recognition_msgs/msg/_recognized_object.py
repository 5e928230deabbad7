"""The classes of object_recognition_msgs/msg/RecognizedObject, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.object_recognition_msgs.msg import RecognizedObject as RecognizedObject
from tfloom.rosidl.class_modules import Metaclass as Metaclass_RecognizedObject

__all__ = ["Metaclass_RecognizedObject", "RecognizedObject"]
