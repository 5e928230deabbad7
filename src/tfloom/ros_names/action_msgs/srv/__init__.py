"""The services of action_msgs."""

from tfloom.interfaces.action_msgs.srv import *
from tfloom.interfaces.action_msgs.srv import __all__
