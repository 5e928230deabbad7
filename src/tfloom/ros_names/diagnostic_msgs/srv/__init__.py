"""The services of diagnostic_msgs."""

from tfloom.interfaces.diagnostic_msgs.srv import *
from tfloom.interfaces.diagnostic_msgs.srv import __all__
