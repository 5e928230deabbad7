"""The actions of others."""

from tfloom.node.action.graph import *
from tfloom.node.action.graph import __all__
