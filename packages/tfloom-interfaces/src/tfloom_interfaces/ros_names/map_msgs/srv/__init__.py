"""The services of map_msgs."""

from tfloom_interfaces.interfaces.map_msgs.srv import *
from tfloom_interfaces.interfaces.map_msgs.srv import __all__
