"""Remove all launch configurations but some."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.frontend.pairs import parse_pairs
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.perform_substitutions import perform_some_substitutions

__all__ = ["ResetLaunchConfigurations", "parse_kept"]


def parse_kept(
    entity: Entity, parser: ParsesActions
) -> dict[tuple[Substitution, ...], list[Substitution]] | None:
    """Return the configurations that the tags `keep` of an entity name, or None if it has none."""
    kept = entity.get_attr("keep", data_type=list[Entity], optional=True)
    return None if kept is None else dict(parse_pairs(kept, parser))


@expose_action("reset")
class ResetLaunchConfigurations(Action):
    """Removes all launch configurations when it is executed, and sets the given ones.

    Args:
        launch_configurations: Value of each configuration to set, by its name. Both may have substitutions, which are
            performed before the others are removed.
        kwargs: As for Action.
    """

    resets_arguments = True
    """For LaunchDescription: the arguments of what follows can't be set from outside."""

    def __init__(
        self,
        launch_configurations: Mapping[Any, SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__launch_configurations = dict(launch_configurations or {})

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions
    ) -> tuple[type[ResetLaunchConfigurations], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `reset`, which may hold tags `keep`."""
        _, kwargs = super().parse(entity, parser)
        if (kept := parse_kept(entity, parser)) is not None:
            kwargs["launch_configurations"] = kept
        return cls, kwargs

    def execute(self, context: LaunchContext) -> None:
        """Remove and set them."""
        kept = {
            perform_some_substitutions(context, name): perform_some_substitutions(context, value)
            for name, value in self.__launch_configurations.items()
        }
        context.launch_configurations.clear()
        context.launch_configurations.update(kept)
