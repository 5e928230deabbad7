"""Action servers."""

from tfloom.node.action.server import *
from tfloom.node.action.server import __all__
