"""Call add_two_ints with 2 and 3, and check after each spin whether the response has arrived."""

from tfloom.demos.demo_nodes_py.add_two_ints_client_async import *
from tfloom.demos.demo_nodes_py.add_two_ints_client_async import __all__
