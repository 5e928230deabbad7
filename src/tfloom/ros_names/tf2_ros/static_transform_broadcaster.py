"""Sends transforms that hold for good."""

from tfloom.tf2_ros.static_transform_broadcaster import *
from tfloom.tf2_ros.static_transform_broadcaster import __all__
