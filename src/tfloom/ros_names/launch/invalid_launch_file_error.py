"""The error of a launch file that cannot be loaded."""

from tfloom.launch.invalid_launch_file_error import *
