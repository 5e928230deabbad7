"""The messages of action_msgs."""

from tfloom.interfaces.action_msgs.msg import *
from tfloom.interfaces.action_msgs.msg import __all__
