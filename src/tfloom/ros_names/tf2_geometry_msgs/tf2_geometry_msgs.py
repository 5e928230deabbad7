"""Transform geometry_msgs; importing this module registers them for `Buffer.transform`."""

from tfloom.interfaces.geometry_msgs.msg import *
from tfloom.tf2_ros.geometry import *
