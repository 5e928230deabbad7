"""Begin a scope of launch configurations."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.push_launch_configurations import PushLaunchConfigurations as PushLaunchConfigurations
