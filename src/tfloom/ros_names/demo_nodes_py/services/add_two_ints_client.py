"""Call add_two_ints with 2 and 3, and wait for the response."""

from tfloom.demos.demo_nodes_py.add_two_ints_client import *
from tfloom.demos.demo_nodes_py.add_two_ints_client import __all__
