"""The services of tf2_msgs."""

from tfloom.interfaces.tf2_msgs.srv import *
from tfloom.interfaces.tf2_msgs.srv import __all__
