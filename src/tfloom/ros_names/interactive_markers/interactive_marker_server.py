"""Markers that viewers show and users move."""

from tfloom.sensing.interactive_marker_server import *
from tfloom.sensing.interactive_marker_server import __all__
