"""The messages of geometry_msgs."""

from tfloom.interfaces.geometry_msgs.msg import *
from tfloom.interfaces.geometry_msgs.msg import __all__
