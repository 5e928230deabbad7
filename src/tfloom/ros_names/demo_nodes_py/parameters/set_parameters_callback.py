"""Set one parameter when another is set, by the pre-set, on-set and post-set callbacks."""

from tfloom.demos.demo_nodes_py.set_parameters_callback import *
from tfloom.demos.demo_nodes_py.set_parameters_callback import __all__
