"""The launch description: the entities of a launch, and the arguments that they declare."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from tfloom.launch.core.base_classes import LaunchDescriptionEntity
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.utilities.argument_errors import entities_error, entity_error

__all__ = ["LaunchDescription"]


class LaunchDescription(LaunchDescriptionEntity):
    """A list of entities, which the launch service visits in order.

    Args:
        initial_entities: The first entities of the list.
        deprecated_reason: A text that is logged as a warning when the description is launched.
    """

    def __init__(
        self,
        initial_entities: Iterable[LaunchDescriptionEntity] | None = None,
        *,
        deprecated_reason: str | None = None,
    ) -> None:
        entities = () if initial_entities is None else initial_entities
        if (error := entities_error("LaunchDescription", entities)) is not None:
            raise error
        self._entities = list(entities)
        for entity in self._entities:
            if (error := entity_error("LaunchDescription", entity)) is not None:
                raise error
        self._deprecated_reason = deprecated_reason

    @property
    def entities(self) -> list[LaunchDescriptionEntity]:
        """Entities, in order."""
        return self._entities

    @property
    def deprecated(self) -> bool:
        """Whether the description is deprecated."""
        return self._deprecated_reason is not None

    @property
    def deprecated_reason(self) -> str | None:
        """Reason of the deprecation."""
        return self._deprecated_reason

    def add_entity(self, entity: LaunchDescriptionEntity) -> None:
        """Add an entity after the others."""
        if (error := entity_error("LaunchDescription", entity)) is not None:
            raise error
        self._entities.append(entity)

    def add_action(self, action: Action) -> None:
        """Add an action after the others."""
        self.add_entity(action)

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the entities, to be visited in order."""
        if self._deprecated_reason is not None:
            location = context.get_locals_as_dict().get("current_launch_file_path")
            get_logger("launch").warning(
                f"launch file [{location}] is deprecated: {self._deprecated_reason}"
                if location
                else f"deprecated launch description: {self._deprecated_reason}"
            )
        return self._entities

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities of the description, without a visit."""
        return self._entities

    def get_launch_arguments(self, conditional_inclusion: bool = False) -> list[Any]:
        """Return the declared arguments (DeclareLaunchArgument), also those of included descriptions.

        Args:
            conditional_inclusion: Whether all of the description is only visited under a condition.
        """
        return [
            argument
            for argument, _ in self.get_launch_arguments_with_include_launch_description_actions(
                conditional_inclusion
            )
        ]

    def get_launch_arguments_with_include_launch_description_actions(
        self, conditional_inclusion: bool = False
    ) -> list[tuple[Any, list[Any] | None]]:
        """Return the declared arguments, each with the IncludeLaunchDescription actions that lead to it, or None.

        An argument that two places declare is listed once, as the first place declares it. The attribute
        `_conditionally_included` of each is set: whether it may not be visited. What can't be loaded before the launch
        has no arguments here, nor has what follows a ResetLaunchConfigurations.
        """
        declarations: dict[str, tuple[Any, list[Any] | None]] = {}
        for argument, inclusions, is_conditional in _declared_arguments(
            self._entities, [], conditional_inclusion
        ):
            if argument.name not in declarations:
                argument._conditionally_included = is_conditional
                declarations[argument.name] = argument, inclusions or None
        return list(declarations.values())


def _declared_arguments(
    entities: Iterable[LaunchDescriptionEntity], inclusions: list[Any], is_conditional: bool
) -> Iterator[tuple[Any, list[Any], bool]]:
    """Walk the tree, and yield each declaration with the inclusions around it, and whether a condition decides.

    The attributes `declares_argument`, `resets_arguments` and `location_without_context` are those of actions in higher
    files. A file that includes itself is not walked again.
    """
    for entity in entities:
        if getattr(entity, "declares_argument", False):
            condition = getattr(entity, "condition", None)
            yield entity, inclusions, is_conditional or condition is not None
        elif getattr(entity, "resets_arguments", False):
            return
        around = inclusions
        if hasattr(entity, "location_without_context"):
            location = entity.location_without_context()
            if location and location in (outer.location_without_context() for outer in inclusions):
                continue
            around = [*inclusions, entity]
        yield from _declared_arguments(entity.describe_sub_entities(), around, is_conditional)
        for _, group in entity.describe_conditional_sub_entities():
            yield from _declared_arguments(group, around, True)
