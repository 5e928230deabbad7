"""Publish a given number of messages, with a chosen reliability."""

from tfloom.demos.demo_nodes_py.talker_qos import *
from tfloom.demos.demo_nodes_py.talker_qos import __all__
