"""Remove a launch configuration."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.unset_launch_configuration import UnsetLaunchConfiguration as UnsetLaunchConfiguration
