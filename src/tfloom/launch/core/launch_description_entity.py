"""The base class of what a launch description consists of, what arguments accept in its place, and these as a list."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Union

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from asyncio import Future

__all__ = [
    "LaunchDescriptionEntity",
    "SomeEntitiesType",
    "SomeEntitiesType_types_tuple",
    "normalize_to_list_of_entities",
]


class LaunchDescriptionEntity(HasPrivateNames):
    """A node of the tree that the launch service visits."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def describe(self) -> str:
        """Return a description for people; derived classes implement it.

        Raises:
            NotImplementedError: the class has no `describe` of its own.
        """
        raise NotImplementedError(f"{type(self).__name__} has no method 'describe'")

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities under this one, as far as they are known before it is visited."""
        return []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the entities that may be visited, in groups, each with the text of its condition."""
        return []

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Do what the entity stands for, and return the entities to visit next, at once and in their order."""
        return None

    def end_visit(self, context: LaunchContext) -> None:
        """Do what follows the visit of the entities that `visit` has returned; derived classes override it."""

    def get_asyncio_future(self) -> Future[Any] | None:
        """Return a future that is done when the entity has ended; None if it ends with its visit."""
        return None


SomeEntitiesType = Union[LaunchDescriptionEntity, Iterable[LaunchDescriptionEntity]]
"""What an argument accepts where it takes entities: one, or several."""

SomeEntitiesType_types_tuple = (LaunchDescriptionEntity, Iterable)
"""The same for `isinstance`."""


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
