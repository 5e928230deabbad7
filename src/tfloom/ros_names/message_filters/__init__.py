"""Synchronize messages of several topics by their stamps."""

from tfloom.tf2_ros.message_filters import *
from tfloom.tf2_ros.message_filters import __all__
