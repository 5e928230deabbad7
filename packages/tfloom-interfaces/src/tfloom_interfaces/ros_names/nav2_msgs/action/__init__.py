"""The actions of nav2_msgs."""

from tfloom_interfaces.interfaces.nav2_msgs.action import *
from tfloom_interfaces.interfaces.nav2_msgs.action import __all__
