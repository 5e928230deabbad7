"""End a scope of launch configurations."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.actions.pop_launch_configurations import PopLaunchConfigurations as PopLaunchConfigurations
