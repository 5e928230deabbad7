"""The services of sensor_msgs."""

from tfloom.interfaces.sensor_msgs.srv import *
from tfloom.interfaces.sensor_msgs.srv import __all__
