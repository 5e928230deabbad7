"""The actions of turtlesim_msgs."""

from tfloom.interfaces.turtlesim_msgs.action import *
from tfloom.interfaces.turtlesim_msgs.action import __all__
