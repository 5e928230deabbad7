"""Callbacks at a fixed period."""

from tfloom.node.timer import *
from tfloom.node.timer import __all__
