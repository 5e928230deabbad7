"""What an argument accepts where it takes entities: one, or several."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Union

from tfloom.launch.launch_description_entity import LaunchDescriptionEntity

__all__ = ["SomeEntitiesType", "SomeEntitiesType_types_tuple"]

SomeEntitiesType = Union[LaunchDescriptionEntity, Iterable[LaunchDescriptionEntity]]

SomeEntitiesType_types_tuple = (LaunchDescriptionEntity, Iterable)
"""The same for `isinstance`."""
