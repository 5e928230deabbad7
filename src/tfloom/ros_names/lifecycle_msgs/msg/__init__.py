"""The messages of lifecycle_msgs."""

from tfloom.interfaces.lifecycle_msgs.msg import *
from tfloom.interfaces.lifecycle_msgs.msg import __all__
