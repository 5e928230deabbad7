"""A parameter that sets another, by the three callbacks about setting."""

from tfloom.demos.demo_nodes_py.set_parameters_callback import *
from tfloom.demos.demo_nodes_py.set_parameters_callback import __all__
