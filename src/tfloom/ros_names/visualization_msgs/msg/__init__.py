"""The messages of visualization_msgs."""

from tfloom.interfaces.visualization_msgs.msg import *
from tfloom.interfaces.visualization_msgs.msg import __all__
