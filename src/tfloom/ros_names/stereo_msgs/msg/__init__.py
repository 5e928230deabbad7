"""The messages of stereo_msgs."""

from tfloom.interfaces.stereo_msgs.msg import *
from tfloom.interfaces.stereo_msgs.msg import __all__
