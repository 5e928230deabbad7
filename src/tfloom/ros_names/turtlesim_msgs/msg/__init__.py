"""The messages of turtlesim_msgs."""

from tfloom.interfaces.turtlesim_msgs.msg import *
from tfloom.interfaces.turtlesim_msgs.msg import __all__
