"""geometry_msgs through transforms; importing it registers them for `Buffer.transform`."""

from tfloom.interfaces.geometry_msgs.msg import *
from tfloom.tf2_ros.geometry import *
