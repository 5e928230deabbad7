"""The messages of tf2_msgs."""

from tfloom.interfaces.tf2_msgs.msg import *
from tfloom.interfaces.tf2_msgs.msg import __all__
