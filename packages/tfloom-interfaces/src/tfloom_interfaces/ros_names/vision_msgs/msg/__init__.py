"""The messages of vision_msgs."""

from tfloom_interfaces.interfaces.vision_msgs.msg import *
from tfloom_interfaces.interfaces.vision_msgs.msg import __all__
