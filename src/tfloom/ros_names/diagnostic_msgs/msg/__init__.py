"""The messages of diagnostic_msgs."""

from tfloom.interfaces.diagnostic_msgs.msg import *
from tfloom.interfaces.diagnostic_msgs.msg import __all__
