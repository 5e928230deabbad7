"""The services of geographic_msgs."""

from tfloom_interfaces.interfaces.geographic_msgs.srv import *
from tfloom_interfaces.interfaces.geographic_msgs.srv import __all__
