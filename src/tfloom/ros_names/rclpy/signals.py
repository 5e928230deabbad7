"""Handlers for SIGINT (Ctrl-C) and SIGTERM."""

from tfloom.node.executing.signals import *
from tfloom.node.executing.signals import __all__
