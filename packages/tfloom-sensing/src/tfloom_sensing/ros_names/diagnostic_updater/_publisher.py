"""Topics that are watched."""

from tfloom_sensing.diagnosed_publisher import *
from tfloom_sensing.diagnosed_publisher import __all__
