"""Managed entities, which follow the transitions of a lifecycle node."""

from tfloom.node.lifecycle.managed_entity import *
from tfloom.node.lifecycle.managed_entity import __all__
