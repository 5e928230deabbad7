"""Group actions, in their own scope."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from tfloom.launch.actions.environment import PopEnvironment, PushEnvironment, ResetEnvironment
from tfloom.launch.actions.launch_configurations import (
    PopLaunchConfigurations,
    PushLaunchConfigurations,
    ResetLaunchConfigurations,
    SetLaunchConfiguration,
    parse_kept,
)
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeSubstitutionsType
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action

__all__ = ["GroupAction"]


@expose_action("group")
class GroupAction(Action):
    """Executes actions together: under one condition, in a scope of launch configurations and environment variables.

    Args:
        actions: The actions, in order.
        scoped: Whether configurations and variables that the actions set are undone after the last one.
        forwarding: Whether a scoped group starts with the configurations and variables around it. Otherwise it starts
            with no configuration and the variables of the launch's start.
        launch_configurations: Value of each configuration to set for the actions, by its name; both may have
            substitutions, which are performed outside of the group.
        left_over_kwargs: As for Action.
    """

    def __init__(
        self,
        actions: Iterable[LaunchDescriptionEntity],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: Mapping[Any, SomeSubstitutionsType] | None = None,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        self.__actions = actions
        self.__scoped = scoped
        self.__forwarding = forwarding
        self.__launch_configurations = dict(launch_configurations or {})
        self.__sub_entities: list[LaunchDescriptionEntity] | None = None

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[GroupAction], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `group`.

        It may have `scoped` and `forwarding`, and holds actions and tags `keep`.
        """
        _, kwargs = super().parse(entity, parser)
        for name in ("scoped", "forwarding"):
            value = entity.get_attr(name, data_type=bool, optional=True)
            if value is not None:
                kwargs[name] = value
        if (kept := parse_kept(entity, parser)) is not None:
            kwargs["launch_configurations"] = kept
        kwargs["actions"] = [
            parser.parse_action(child) for child in entity.children if child.type_name != "keep"
        ]
        return cls, kwargs

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the actions between those that begin and end the scope."""
        if self.__sub_entities is None:
            self.__sub_entities = self._scope(list(self.__actions))
        return self.__sub_entities

    def _scope(self, actions: list[LaunchDescriptionEntity]) -> list[LaunchDescriptionEntity]:
        settings: list[LaunchDescriptionEntity] = [
            SetLaunchConfiguration(name, value) for name, value in self.__launch_configurations.items()
        ]
        if not self.__scoped:
            return [*settings, *actions]
        if not self.__forwarding:
            settings = [ResetEnvironment(), ResetLaunchConfigurations(self.__launch_configurations)]
        return [
            PushLaunchConfigurations(),
            PushEnvironment(),
            *settings,
            *actions,
            PopEnvironment(),
            PopLaunchConfigurations(),
        ]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return what to visit: see `get_sub_entities`."""
        return self.get_sub_entities()
