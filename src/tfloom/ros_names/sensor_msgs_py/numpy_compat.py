"""Convert structured arrays to plain ones and back."""

from tfloom.tf2_ros.numpy_compat import *
from tfloom.tf2_ros.numpy_compat import __all__
