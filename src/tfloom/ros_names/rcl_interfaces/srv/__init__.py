"""The services of rcl_interfaces."""

from tfloom.interfaces.rcl_interfaces.srv import *
from tfloom.interfaces.rcl_interfaces.srv import __all__
