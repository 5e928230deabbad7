"""Entities in every form as a list."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.some_entities_type import SomeEntitiesType

__all__ = ["normalize_to_list_of_entities"]


def normalize_to_list_of_entities(
    entities: Iterable[SomeEntitiesType],
) -> list[LaunchDescriptionEntity]:
    """Return all entities of nested lists, in order."""
    flat: list[LaunchDescriptionEntity] = []
    for item in entities:
        if isinstance(item, Iterable):
            flat += normalize_to_list_of_entities(item)
        else:
            flat.append(item)
    return flat
