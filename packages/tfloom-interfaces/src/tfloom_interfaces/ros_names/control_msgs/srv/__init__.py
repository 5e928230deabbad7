"""The services of control_msgs."""

from tfloom_interfaces.interfaces.control_msgs.srv import *
from tfloom_interfaces.interfaces.control_msgs.srv import __all__
