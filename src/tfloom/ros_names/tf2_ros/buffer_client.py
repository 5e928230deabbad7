"""Look transforms up in the buffer of another program, by an action."""

from tfloom.tf2_ros.buffer_client import *
from tfloom.tf2_ros.buffer_client import __all__
