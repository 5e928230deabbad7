"""Serve add_two_ints: respond with the sum of two integers."""

from tfloom.demos.demo_nodes_py.add_two_ints_server import *
from tfloom.demos.demo_nodes_py.add_two_ints_server import __all__
