"""What buffers share: transforming whole objects, by functions that are registered for their types."""

from tfloom.tf2_ros.buffer_interface import *
from tfloom.tf2_ros.buffer_interface import __all__
