"""Log each message on chatter."""

from tfloom.demos.demo_nodes_py.listener import *
from tfloom.demos.demo_nodes_py.listener import __all__
