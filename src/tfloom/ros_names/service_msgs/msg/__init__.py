"""The messages of service_msgs."""

from tfloom.interfaces.service_msgs.msg import *
from tfloom.interfaces.service_msgs.msg import __all__
