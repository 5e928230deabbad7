"""Ctrl-C and SIGTERM."""

from tfloom.node.signals import *
from tfloom.node.signals import __all__
