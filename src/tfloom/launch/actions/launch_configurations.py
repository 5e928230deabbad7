"""Actions that change the launch configurations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tfloom.launch.actions.texts import NamedValue
from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions, parse_pairs
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.utilities.substitutions import (
    normalize_to_list_of_substitutions,
    perform_some_substitutions,
    perform_substitutions,
)

__all__ = [
    "PopLaunchConfigurations",
    "PushLaunchConfigurations",
    "ResetLaunchConfigurations",
    "SetLaunchConfiguration",
    "UnsetLaunchConfiguration",
    "parse_kept",
]


@expose_action("let")
class SetLaunchConfiguration(NamedValue):
    """Sets a launch configuration when it is executed; an earlier value is replaced.

    The configuration is a value of the running launch, which `LaunchConfiguration` substitutes. It lasts to the end of
    the scope: of the scoped group or else of the whole launch.

    Args:
        name: Name of the configuration; it may have substitutions.
        value: Its value; it may have substitutions.
        kwargs: As for Action.
    """

    def execute(self, context: LaunchContext) -> None:
        """Set the configuration in the scope that is visited, from here on."""
        name = perform_substitutions(context, self.name)
        context.launch_configurations[name] = perform_substitutions(context, self.value)


class UnsetLaunchConfiguration(Action):
    """Removes a launch configuration when it is executed; one that isn't set is not an error.

    Args:
        name: Name of the configuration; it may have substitutions.
        kwargs: As for Action.
    """

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    @property
    def name(self) -> list[Substitution]:
        """Name of the configuration to remove."""
        return self.__name

    def execute(self, context: LaunchContext) -> None:
        """Remove the configuration, if it is set."""
        context.launch_configurations.pop(perform_substitutions(context, self.__name), None)


class PushLaunchConfigurations(Action):
    """Begins a scope: what is set from now on is undone by the next `PopLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Save a copy of the configurations."""
        context._push_launch_configurations()


class PopLaunchConfigurations(Action):
    """Ends a scope: restores the launch configurations of the last `PushLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the configurations."""
        context._pop_launch_configurations()


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
        """Remove all configurations but those to keep, which get the values given here."""
        kept = {
            perform_some_substitutions(context, name): perform_some_substitutions(context, value)
            for name, value in self.__launch_configurations.items()
        }
        context.launch_configurations.clear()
        context.launch_configurations.update(kept)
