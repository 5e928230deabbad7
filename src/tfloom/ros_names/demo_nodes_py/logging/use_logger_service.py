"""Set the logger level of another node by its services, and log at each level."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.demos.demo_nodes_py.use_logger_service import LoggerServiceNode as LoggerServiceNode
from tfloom.demos.demo_nodes_py.use_logger_service import TestNode as TestNode
from tfloom.demos.demo_nodes_py.use_logger_service import main as main
