"""The messages of example_interfaces."""

from tfloom.interfaces.example_interfaces.msg import *
from tfloom.interfaces.example_interfaces.msg import __all__
