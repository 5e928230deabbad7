"""The base class of what a launch description consists of."""

from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
