"""The messages of builtin_interfaces."""

from tfloom.interfaces.builtin_interfaces.msg import *
from tfloom.interfaces.builtin_interfaces.msg import __all__
