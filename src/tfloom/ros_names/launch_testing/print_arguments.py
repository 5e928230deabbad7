"""Printed launch arguments."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.print_arguments import print_arguments_of_launch_description as print_arguments_of_launch_description
