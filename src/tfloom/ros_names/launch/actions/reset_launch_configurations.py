"""Remove all launch configurations but some."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.reset_launch_configurations import ResetLaunchConfigurations as ResetLaunchConfigurations
