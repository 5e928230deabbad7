"""A listener that asks for reliability or not, and ends after so many messages."""

from tfloom.demos.demo_nodes_py.listener_qos import *
from tfloom.demos.demo_nodes_py.listener_qos import __all__
