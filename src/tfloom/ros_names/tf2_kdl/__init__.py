"""Transform PyKDL's values; importing this module registers them for `Buffer.transform`."""

from typing import TYPE_CHECKING

import PyKDL as PyKDL
import tf2_ros as tf2_ros

from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
from tfloom.tf2_ros.kdl import *

if TYPE_CHECKING:
    from tf2_kdl import tf2_kdl as tf2_kdl
else:
    from tfloom.ros_modules import submodules

    __getattr__ = submodules("tf2_kdl")
