"""Set a launch configuration."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.set_launch_configuration import SetLaunchConfiguration as SetLaunchConfiguration
