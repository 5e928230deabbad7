"""The actions of control_msgs."""

from tfloom_interfaces.interfaces.control_msgs.action import *
from tfloom_interfaces.interfaces.control_msgs.action import __all__
