"""The messages of ackermann_msgs."""

from tfloom_interfaces.interfaces.ackermann_msgs.msg import *
from tfloom_interfaces.interfaces.ackermann_msgs.msg import __all__
