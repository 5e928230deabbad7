"""Clients for the parameters of another node."""

from tfloom.node.builtin.parameter_client import *
from tfloom.node.builtin.parameter_client import __all__
