"""Log what the talker says."""

from tfloom.demos.demo_nodes_py.listener import *
from tfloom.demos.demo_nodes_py.listener import __all__
