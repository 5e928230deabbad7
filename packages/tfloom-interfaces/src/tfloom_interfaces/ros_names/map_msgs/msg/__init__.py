"""The messages of map_msgs."""

from tfloom_interfaces.interfaces.map_msgs.msg import *
from tfloom_interfaces.interfaces.map_msgs.msg import __all__
