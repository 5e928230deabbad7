"""The messages of statistics_msgs."""

from tfloom.interfaces.statistics_msgs.msg import *
from tfloom.interfaces.statistics_msgs.msg import __all__
