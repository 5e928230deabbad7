"""Clients of services."""

from tfloom.node.client import *
from tfloom.node.client import __all__
