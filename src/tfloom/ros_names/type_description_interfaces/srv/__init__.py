"""The services of type_description_interfaces."""

from tfloom.interfaces.type_description_interfaces.srv import *
from tfloom.interfaces.type_description_interfaces.srv import __all__
