"""Sends transforms that change."""

from tfloom.tf2_ros.transform_broadcaster import *
from tfloom.tf2_ros.transform_broadcaster import __all__
