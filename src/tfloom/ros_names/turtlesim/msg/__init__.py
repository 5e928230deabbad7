"""The messages of turtlesim."""

from tfloom.interfaces.turtlesim.msg import *
from tfloom.interfaces.turtlesim.msg import __all__
