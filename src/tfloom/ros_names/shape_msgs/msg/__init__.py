"""The messages of shape_msgs."""

from tfloom.interfaces.shape_msgs.msg import *
from tfloom.interfaces.shape_msgs.msg import __all__
