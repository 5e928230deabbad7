"""The messages of rosgraph_msgs."""

from tfloom.interfaces.rosgraph_msgs.msg import *
from tfloom.interfaces.rosgraph_msgs.msg import __all__
