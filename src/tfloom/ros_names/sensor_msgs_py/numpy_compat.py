"""Between arrays with named fields and plain ones."""

from tfloom.tf2_ros.numpy_compat import *
from tfloom.tf2_ros.numpy_compat import __all__
