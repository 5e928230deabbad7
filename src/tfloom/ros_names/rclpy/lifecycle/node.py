"""Nodes with a lifecycle."""

from tfloom.node.lifecycle.node import *
from tfloom.node.lifecycle.node import __all__
