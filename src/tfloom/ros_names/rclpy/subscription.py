"""Subscriptions."""

from tfloom.node.endpoints.subscription import *
from tfloom.node.endpoints.subscription import __all__
