"""The services of lifecycle_msgs."""

from tfloom.interfaces.lifecycle_msgs.srv import *
from tfloom.interfaces.lifecycle_msgs.srv import __all__
