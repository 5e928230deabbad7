"""Servers of services."""

from tfloom.node.service import *
from tfloom.node.service import __all__
