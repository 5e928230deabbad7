"""The classes of moveit_msgs/msg/PlanningScene, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PlanningScene as PlanningScene
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlanningScene

__all__ = ["Metaclass_PlanningScene", "PlanningScene"]
