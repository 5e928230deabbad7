"""Log the very bytes of what the talker says."""

from tfloom.demos.demo_nodes_py.listener_serialized import *
from tfloom.demos.demo_nodes_py.listener_serialized import __all__
