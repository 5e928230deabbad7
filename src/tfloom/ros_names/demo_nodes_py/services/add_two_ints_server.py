"""Add two numbers for whoever asks."""

from tfloom.demos.demo_nodes_py.add_two_ints_server import *
from tfloom.demos.demo_nodes_py.add_two_ints_server import __all__
