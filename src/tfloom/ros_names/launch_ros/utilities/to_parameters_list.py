"""Evaluated parameters as the messages of a node's parameters."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.utilities.to_parameters_list import to_parameters_list as to_parameters_list
