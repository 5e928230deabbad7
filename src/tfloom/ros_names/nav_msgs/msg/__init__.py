"""The messages of nav_msgs."""

from tfloom.interfaces.nav_msgs.msg import *
from tfloom.interfaces.nav_msgs.msg import __all__
