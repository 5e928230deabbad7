"""The services of nav2_msgs."""

from tfloom_interfaces.interfaces.nav2_msgs.srv import *
from tfloom_interfaces.interfaces.nav2_msgs.srv import __all__
