"""Executors."""

from tfloom.node.executors import *
from tfloom.node.executors import __all__
