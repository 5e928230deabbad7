"""The classes of nav2_msgs/msg/Particle, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import Particle as Particle
from tfloom.rosidl.class_modules import Metaclass as Metaclass_Particle

__all__ = ["Metaclass_Particle", "Particle"]
