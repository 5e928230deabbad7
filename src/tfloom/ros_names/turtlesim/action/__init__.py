"""The actions of turtlesim."""

from tfloom.interfaces.turtlesim.action import *
from tfloom.interfaces.turtlesim.action import __all__
