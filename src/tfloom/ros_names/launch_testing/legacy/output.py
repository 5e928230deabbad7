"""Checks of output, for the older way."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.legacy_output import create_output_lines_filter as create_output_lines_filter
from tfloom.launch.testing.legacy_output import create_output_lines_test as create_output_lines_test
from tfloom.launch.testing.legacy_output import create_output_regex_test as create_output_regex_test
from tfloom.launch.testing.legacy_output import create_output_test_from_file as create_output_test_from_file
from tfloom.launch.testing.output import get_default_filtered_patterns as get_default_filtered_patterns
from tfloom.launch.testing.output import get_default_filtered_prefixes as get_default_filtered_prefixes
from tfloom.launch.testing.ros.output import get_rmw_output_filter as get_rmw_output_filter
