"""The messages of rosbag2_interfaces."""

from tfloom.interfaces.rosbag2_interfaces.msg import *
from tfloom.interfaces.rosbag2_interfaces.msg import __all__
