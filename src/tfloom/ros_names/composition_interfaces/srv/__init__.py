"""The services of composition_interfaces."""

from tfloom.interfaces.composition_interfaces.srv import *
from tfloom.interfaces.composition_interfaces.srv import __all__
