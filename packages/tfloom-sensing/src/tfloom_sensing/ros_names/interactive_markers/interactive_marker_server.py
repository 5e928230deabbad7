"""Markers that viewers show and users move."""

from tfloom_sensing.interactive_marker_server import *
from tfloom_sensing.interactive_marker_server import __all__
