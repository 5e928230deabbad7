"""Filters of what a wire prints."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.ros.output import basic_output_filter as basic_output_filter
from tfloom.launch.testing.ros.output import get_rmw_output_filter as get_rmw_output_filter
