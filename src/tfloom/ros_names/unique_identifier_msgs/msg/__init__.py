"""The messages of unique_identifier_msgs."""

from tfloom.interfaces.unique_identifier_msgs.msg import *
from tfloom.interfaces.unique_identifier_msgs.msg import __all__
