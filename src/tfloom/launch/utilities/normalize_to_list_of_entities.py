"""Entities in every form as a list."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.core.launch_description_entity import LaunchDescriptionEntity, SomeEntitiesType

__all__ = ["normalize_to_list_of_entities"]


def normalize_to_list_of_entities(
    entities: Iterable[SomeEntitiesType], *, name: str = "entities"
) -> list[LaunchDescriptionEntity]:
    """Return all entities of nested lists, in order.

    Args:
        entities: The entities, and lists of them.
        name: What the error calls it.

    Raises:
        TypeError: an item is not an entity.
    """
    flat: list[LaunchDescriptionEntity] = []
    for item in entities:
        if isinstance(item, LaunchDescriptionEntity):
            flat.append(item)
        elif isinstance(item, Iterable) and not isinstance(item, (str, bytes)):
            flat += normalize_to_list_of_entities(item, name=name)
        else:
            raise TypeError(
                f"expected all items in '{name}' iterable to be of type 'LaunchDescriptionEntity' "
                f"but got '{type(item)}'"
            )
    return flat
