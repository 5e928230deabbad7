"""What the graph tells of one publisher or subscription."""

from tfloom.node.qos.topic_endpoint_info import *
from tfloom.node.qos.topic_endpoint_info import __all__
