"""Set, list, get, load and delete parameters of another node, parameter_blackboard."""

from tfloom.demos.demo_nodes_py.async_param_client import *
from tfloom.demos.demo_nodes_py.async_param_client import __all__
