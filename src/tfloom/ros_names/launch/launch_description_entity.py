"""The base class of what a launch description consists of."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
