"""The messages of std_msgs."""

from tfloom.interfaces.std_msgs.msg import *
from tfloom.interfaces.std_msgs.msg import __all__
