"""The messages of type_description_interfaces."""

from tfloom.interfaces.type_description_interfaces.msg import *
from tfloom.interfaces.type_description_interfaces.msg import __all__
