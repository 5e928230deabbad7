"""Futures and tasks."""

from tfloom.node.executing.task import *
from tfloom.node.executing.task import __all__
