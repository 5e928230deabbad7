"""Looks transforms up in a buffer that another program keeps."""

from tfloom.tf2_ros.buffer_client import *
from tfloom.tf2_ros.buffer_client import __all__
