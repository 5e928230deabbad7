"""The classes of object_recognition_msgs/msg/ObjectInformation, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.object_recognition_msgs.msg import ObjectInformation as ObjectInformation
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ObjectInformation

__all__ = ["Metaclass_ObjectInformation", "ObjectInformation"]
