"""The services of rosbag2_interfaces."""

from tfloom.interfaces.rosbag2_interfaces.srv import *
from tfloom.interfaces.rosbag2_interfaces.srv import __all__
