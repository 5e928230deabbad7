"""A description to launch."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.events.include_launch_description import IncludeLaunchDescription as IncludeLaunchDescription
