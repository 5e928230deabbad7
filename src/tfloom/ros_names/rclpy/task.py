"""Futures and tasks."""

from tfloom.node.task import *
from tfloom.node.task import __all__
