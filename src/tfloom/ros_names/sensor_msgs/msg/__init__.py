"""The messages of sensor_msgs."""

from tfloom.interfaces.sensor_msgs.msg import *
from tfloom.interfaces.sensor_msgs.msg import __all__
