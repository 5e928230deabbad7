"""Normalized parameters with their substitutions performed."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameter_dict as evaluate_parameter_dict
from tfloom.launch.ros.utilities.evaluate_parameters import evaluate_parameters as evaluate_parameters
