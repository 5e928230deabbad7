"""Entities in every form as a list."""

from tfloom.launch.launch_description_entity import LaunchDescriptionEntity as LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType as SomeEntitiesType
from tfloom.launch.utilities.normalize_to_list_of_entities import (
    normalize_to_list_of_entities as normalize_to_list_of_entities,
)
