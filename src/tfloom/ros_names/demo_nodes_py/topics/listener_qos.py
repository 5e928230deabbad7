"""Log messages, with a chosen reliability, until a given number has arrived."""

from tfloom.demos.demo_nodes_py.listener_qos import *
from tfloom.demos.demo_nodes_py.listener_qos import __all__
