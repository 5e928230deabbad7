"""Executors."""

from tfloom.node.executing.executors import *
from tfloom.node.executing.executors import __all__
