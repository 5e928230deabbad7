"""Nodes with a lifecycle."""

from tfloom.node.lifecycle import *
from tfloom.node.lifecycle import __all__
