"""A client and a server of add_two_ints that publish their service events."""

from tfloom.demos.demo_nodes_py.introspection import *
from tfloom.demos.demo_nodes_py.introspection import __all__
