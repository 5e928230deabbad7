"""The classes of nav2_msgs/msg/CollisionDetectorState, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import CollisionDetectorState as CollisionDetectorState
from tfloom.rosidl.class_modules import Metaclass as Metaclass_CollisionDetectorState

__all__ = ["Metaclass_CollisionDetectorState", "CollisionDetectorState"]
