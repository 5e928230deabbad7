"""Transform PyKDL's values; importing this module registers them for `Buffer.transform`."""

import PyKDL as PyKDL
import tf2_ros as tf2_ros

from tfloom.interfaces.geometry_msgs.msg import PointStamped as PointStamped
from tfloom.tf2_ros.kdl import *
