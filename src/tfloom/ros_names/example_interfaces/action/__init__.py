"""The actions of example_interfaces."""

from tfloom.interfaces.example_interfaces.action import *
from tfloom.interfaces.example_interfaces.action import __all__
