"""The messages of control_msgs."""

from tfloom_interfaces.interfaces.control_msgs.msg import *
from tfloom_interfaces.interfaces.control_msgs.msg import __all__
