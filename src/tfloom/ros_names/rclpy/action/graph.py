"""Queries for the actions on the graph."""

from tfloom.node.action.graph import *
from tfloom.node.action.graph import __all__
