"""The buffer of a program: lookups that wait for a transform, and futures of transforms."""

from tfloom.tf2_ros.buffer import *
from tfloom.tf2_ros.buffer import __all__
