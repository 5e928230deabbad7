"""Serve lookups of other programs from one buffer, by an action."""

from tfloom.tf2_ros.buffer_server import *
from tfloom.tf2_ros.buffer_server import __all__
