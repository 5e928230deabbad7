"""Quality of service."""

from tfloom.node.qos import *
from tfloom.node.qos import __all__
