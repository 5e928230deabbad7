"""Quality of service: profiles, policies and their compatibility."""

from tfloom.node.qos.qos import *
from tfloom.node.values.duration import Duration as Duration
