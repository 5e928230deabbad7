"""The services of visualization_msgs."""

from tfloom.interfaces.visualization_msgs.srv import *
from tfloom.interfaces.visualization_msgs.srv import __all__
