"""Base of buffers: transform objects by the functions registered for their types."""

from tfloom.tf2_ros.buffer_interface import *
from tfloom.tf2_ros.buffer_interface import __all__
