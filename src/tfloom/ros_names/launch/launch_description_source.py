"""Where an included launch description comes from."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description_source import LaunchDescriptionSource as LaunchDescriptionSource
