"""Description of a publisher or subscription on the graph."""

from tfloom.node.qos.topic_endpoint_info import *
from tfloom.node.qos.topic_endpoint_info import __all__
