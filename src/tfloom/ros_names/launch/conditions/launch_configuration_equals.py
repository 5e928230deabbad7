"""A condition on the value of a launch configuration."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.conditions.launch_configuration_equals import LaunchConfigurationEquals as LaunchConfigurationEquals
