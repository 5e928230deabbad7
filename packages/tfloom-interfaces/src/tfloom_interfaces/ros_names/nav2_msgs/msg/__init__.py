"""The messages of nav2_msgs."""

from tfloom_interfaces.interfaces.nav2_msgs.msg import *
from tfloom_interfaces.interfaces.nav2_msgs.msg import __all__
