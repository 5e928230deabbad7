"""Publish transforms on /tf."""

from tfloom.tf2_ros.transform_broadcaster import *
from tfloom.tf2_ros.transform_broadcaster import __all__
