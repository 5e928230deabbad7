"""Log the serialized bytes of each message on chatter."""

from tfloom.demos.demo_nodes_py.listener_serialized import *
from tfloom.demos.demo_nodes_py.listener_serialized import __all__
