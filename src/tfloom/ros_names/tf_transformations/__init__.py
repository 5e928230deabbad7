"""Rotations and matrices; quaternions are x, y, z, w."""

from tfloom.tf2_ros.transformations import *
from tfloom.tf2_ros.transformations import __all__
