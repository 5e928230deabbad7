"""The messages of rcl_interfaces."""

from tfloom.interfaces.rcl_interfaces.msg import *
from tfloom.interfaces.rcl_interfaces.msg import __all__
