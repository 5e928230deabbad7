"""Ask what 2 and 3 are, and wait for the answer."""

from tfloom.demos.demo_nodes_py.add_two_ints_client import *
from tfloom.demos.demo_nodes_py.add_two_ints_client import __all__
