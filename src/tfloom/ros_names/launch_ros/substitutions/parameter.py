"""A parameter that SetParameter has set as a substitution: `$(param NAME)`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.substitutions.parameter import Parameter as Parameter
