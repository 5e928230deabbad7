"""The classes of moveit_msgs/msg/PlanningSceneWorld, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PlanningSceneWorld as PlanningSceneWorld
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlanningSceneWorld

__all__ = ["Metaclass_PlanningSceneWorld", "PlanningSceneWorld"]
