"""Set the logger level of another node by its services, and log at each level."""

from tfloom.demos.demo_nodes_py.use_logger_service import *
from tfloom.demos.demo_nodes_py.use_logger_service import __all__
