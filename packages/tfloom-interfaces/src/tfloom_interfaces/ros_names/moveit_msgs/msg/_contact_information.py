"""The classes of moveit_msgs/msg/ContactInformation, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import ContactInformation as ContactInformation
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ContactInformation

__all__ = ["Metaclass_ContactInformation", "ContactInformation"]
