"""Ask what 2 and 3 are, and look between callbacks whether the answer is there."""

from tfloom.demos.demo_nodes_py.add_two_ints_client_async import *
from tfloom.demos.demo_nodes_py.add_two_ints_client_async import __all__
