"""The base class of what a launch description consists of, and what arguments accept in its place."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Union

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.ros_imports.guard import ros_repr

if TYPE_CHECKING:
    from asyncio import Future

__all__ = ["LaunchDescriptionEntity", "SomeEntitiesType", "SomeEntitiesType_types_tuple"]


class LaunchDescriptionEntity(HasPrivateNames):
    """A node of the tree that the launch service visits."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)

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
