"""Quality of service."""

from tfloom.node.qos.qos import *
from tfloom.node.qos.qos import __all__
