"""The visit of a tree of entities."""

from tfloom.launch.launch_context import LaunchContext as LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.utilities.visit_all_entities_and_collect_futures import (
    visit_all_entities_and_collect_futures as visit_all_entities_and_collect_futures,
)
