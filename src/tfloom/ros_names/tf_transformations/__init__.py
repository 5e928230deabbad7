"""Functions for rotations and homogeneous matrices; quaternions are (x, y, z, w)."""

from tfloom.tf2_ros.arcball import *
from tfloom.tf2_ros.projections import *
from tfloom.tf2_ros.transformations import *
