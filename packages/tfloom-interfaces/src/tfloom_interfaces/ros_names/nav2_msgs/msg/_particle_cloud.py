"""The classes of nav2_msgs/msg/ParticleCloud, for type checkers: `tfloom.rosidl.class_modules` makes the module."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import ParticleCloud as ParticleCloud
from tfloom.rosidl.class_modules import Metaclass as Metaclass_ParticleCloud

__all__ = ["Metaclass_ParticleCloud", "ParticleCloud"]
