"""Topics that are watched."""

from tfloom.sensing.diagnosed_publisher import *
from tfloom.sensing.diagnosed_publisher import __all__
