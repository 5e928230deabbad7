"""Handler that adds a description to the launch."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.event_handlers.on_include_launch_description import OnIncludeLaunchDescription as OnIncludeLaunchDescription
