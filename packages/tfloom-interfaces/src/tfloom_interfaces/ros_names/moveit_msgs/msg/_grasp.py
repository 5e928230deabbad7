"""The classes of moveit_msgs/msg/Grasp, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import Grasp as Grasp
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Grasp

__all__ = ["Metaclass_Grasp", "Grasp"]
