"""A talker that is reliable or not, and has only so much to say."""

from tfloom.demos.demo_nodes_py.talker_qos import *
from tfloom.demos.demo_nodes_py.talker_qos import __all__
