"""The messages of geographic_msgs."""

from tfloom_interfaces.interfaces.geographic_msgs.msg import *
from tfloom_interfaces.interfaces.geographic_msgs.msg import __all__
