"""The classes of moveit_msgs/msg/PlanningSceneComponents, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.moveit_msgs.msg import PlanningSceneComponents as PlanningSceneComponents
from tfloom.rosidl.class_modules import Metaclass as Metaclass_PlanningSceneComponents

__all__ = ["Metaclass_PlanningSceneComponents", "PlanningSceneComponents"]
