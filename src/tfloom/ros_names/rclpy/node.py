"""Nodes."""

from tfloom.node.node import *
from tfloom.node.node import __all__
