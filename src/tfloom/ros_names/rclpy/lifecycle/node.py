"""Lifecycle nodes."""

from tfloom.node.lifecycle.node import *
from tfloom.node.lifecycle.node import __all__
