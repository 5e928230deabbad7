"""The services of turtlesim."""

from tfloom.interfaces.turtlesim.srv import *
from tfloom.interfaces.turtlesim.srv import __all__
