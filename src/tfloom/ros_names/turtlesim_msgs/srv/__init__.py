"""The services of turtlesim_msgs."""

from tfloom.interfaces.turtlesim_msgs.srv import *
from tfloom.interfaces.turtlesim_msgs.srv import __all__
