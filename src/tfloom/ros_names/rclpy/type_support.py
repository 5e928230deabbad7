"""Checks that a class is a message or service class."""

from tfloom.node.values.type_support import *
from tfloom.node.values.type_support import __all__
