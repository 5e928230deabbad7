"""The messages of trajectory_msgs."""

from tfloom.interfaces.trajectory_msgs.msg import *
from tfloom.interfaces.trajectory_msgs.msg import __all__
