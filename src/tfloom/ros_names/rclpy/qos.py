"""Quality of service."""

from tfloom.node.qos.qos import *
from tfloom.node.values.duration import Duration as Duration
