"""The buffer that programs use: lookups that wait, and futures of transforms to come."""

from tfloom.tf2_ros.buffer import *
from tfloom.tf2_ros.buffer import __all__
