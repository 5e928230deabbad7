"""The services of nav_msgs."""

from tfloom.interfaces.nav_msgs.srv import *
from tfloom.interfaces.nav_msgs.srv import __all__
