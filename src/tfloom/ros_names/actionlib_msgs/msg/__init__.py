"""The messages of actionlib_msgs."""

from tfloom.interfaces.actionlib_msgs.msg import *
from tfloom.interfaces.actionlib_msgs.msg import __all__
