"""Printed launch arguments."""

from tfloom.launch.testing.print_arguments import (
    print_arguments_of_launch_description as print_arguments_of_launch_description,
)
