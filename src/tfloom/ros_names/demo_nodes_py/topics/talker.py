"""Publish "Hello World" and a count on chatter, once a second."""

from tfloom.demos.demo_nodes_py.talker import *
from tfloom.demos.demo_nodes_py.talker import __all__
