"""Launch arguments of a command line."""

from tfloom.launch.testing.parse_arguments import parse_launch_arguments as parse_launch_arguments
