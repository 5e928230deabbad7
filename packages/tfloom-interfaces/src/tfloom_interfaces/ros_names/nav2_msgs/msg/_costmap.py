"""The classes of nav2_msgs/msg/Costmap, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import Costmap as Costmap
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Costmap

__all__ = ["Metaclass_Costmap", "Costmap"]
