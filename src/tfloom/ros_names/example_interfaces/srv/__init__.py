"""The services of example_interfaces."""

from tfloom.interfaces.example_interfaces.srv import *
from tfloom.interfaces.example_interfaces.srv import __all__
