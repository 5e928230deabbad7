"""Publish static transforms on /tf_static."""

from tfloom.tf2_ros.static_transform_broadcaster import *
from tfloom.tf2_ros.static_transform_broadcaster import __all__
