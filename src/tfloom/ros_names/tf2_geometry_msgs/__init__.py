"""Transform geometry_msgs; importing this module registers them for `Buffer.transform`."""

from typing import TYPE_CHECKING

from tfloom.interfaces.geometry_msgs.msg import *
from tfloom.tf2_ros.geometry import *

if TYPE_CHECKING:
    from tf2_geometry_msgs import tf2_geometry_msgs as tf2_geometry_msgs
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_geometry_msgs")
