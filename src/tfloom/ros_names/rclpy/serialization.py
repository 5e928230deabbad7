"""Serialization of messages to bytes and back."""

from tfloom.node.values.serialization import *
from tfloom.node.values.serialization import __all__
