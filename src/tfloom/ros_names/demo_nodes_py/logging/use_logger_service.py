"""Set another node's logger level by its services, and see what it logs then."""

from tfloom.demos.demo_nodes_py.use_logger_service import *
from tfloom.demos.demo_nodes_py.use_logger_service import __all__
