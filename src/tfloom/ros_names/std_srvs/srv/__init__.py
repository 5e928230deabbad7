"""The services of std_srvs."""

from tfloom.interfaces.std_srvs.srv import *
from tfloom.interfaces.std_srvs.srv import __all__
