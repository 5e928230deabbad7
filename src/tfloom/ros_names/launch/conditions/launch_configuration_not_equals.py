"""A condition on a value that a launch configuration does not have."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.conditions.launch_configuration_not_equals import LaunchConfigurationNotEquals as LaunchConfigurationNotEquals
