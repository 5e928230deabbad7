"""Launch arguments of a command line."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.parse_arguments import parse_launch_arguments as parse_launch_arguments
