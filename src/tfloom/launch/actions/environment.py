"""Actions that change the environment variables of a launch."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from tfloom.launch.actions.texts import ActionOfTexts, NamedValue
from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions, parse_pairs
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.utilities.substitutions import (
    normalize_to_list_of_substitutions,
    perform_substitutions,
)
from tfloom.launch.utilities.type_utils import (
    NormalizedValueType,
    normalize_typed_substitution,
    perform_typed_substitution,
)

__all__ = [
    "AppendEnvironmentVariable",
    "PopEnvironment",
    "PushEnvironment",
    "ReplaceEnvironmentVariables",
    "ResetEnvironment",
    "SetEnvironmentVariable",
    "UnsetEnvironmentVariable",
]


@expose_action("append_env")
class AppendEnvironmentVariable(NamedValue):
    """Appends to an environment variable when it is executed, or sets it if there is none.

    Args:
        name: Name of the variable; it may have substitutions.
        value: Text to append; it may have substitutions.
        prepend: Whether to put the text first instead; it may have substitutions, whose text is read as YAML.
        separator: Text between the two: by default what the system puts between two paths.
        kwargs: As for Action.
    """

    def __init__(
        self,
        name: SomeSubstitutionsType,
        value: SomeSubstitutionsType,
        prepend: bool | SomeSubstitutionsType = False,
        separator: SomeSubstitutionsType = os.pathsep,
        **kwargs: Any,
    ) -> None:
        super().__init__(name, value, **kwargs)
        self.__prepend = normalize_typed_substitution(prepend, bool)
        self.__separator = normalize_to_list_of_substitutions(separator)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `append_env`.

        It has `name` and `value`, and may have `prepend` and `separator`.
        """
        _, kwargs = super().parse(entity, parser)
        prepend = entity.get_attr("prepend", optional=True, data_type=bool, can_be_str=True)
        if prepend is not None:
            kwargs["prepend"] = parser.parse_if_substitutions(prepend)
        separator = entity.get_attr("separator", optional=True)
        if separator is not None:
            kwargs["separator"] = parser.parse_substitution(separator)
        return cls, kwargs

    @property
    def prepend(self) -> NormalizedValueType:
        """Whether to put the text first instead."""
        return self.__prepend

    @property
    def separator(self) -> list[Substitution]:
        """The text between the two."""
        return self.__separator

    def execute(self, context: LaunchContext) -> None:
        """Append the value to the variable, or set it if it has none."""
        name = perform_substitutions(context, self.name)
        parts = [perform_substitutions(context, self.value)]
        if name in context.environment:
            is_first = perform_typed_substitution(context, self.__prepend, bool)
            parts.insert(1 if is_first else 0, context.environment[name])
        context.environment[name] = perform_substitutions(context, self.__separator).join(parts)


@expose_action("set_env")
class SetEnvironmentVariable(NamedValue):
    """Sets an environment variable, when it is executed, for the processes that are started later in the scope.

    Args:
        name: Name of the variable; it may have substitutions.
        value: Its value; it may have substitutions.
        kwargs: As for Action.
    """

    def execute(self, context: LaunchContext) -> None:
        """Set the variable for the processes that are started from here on."""
        name = perform_substitutions(context, self.name)
        context.environment[name] = perform_substitutions(context, self.value)


@expose_action("unset_env")
class UnsetEnvironmentVariable(ActionOfTexts):
    """Removes an environment variable, when it is executed; one that isn't set is not an error.

    Args:
        name: Name of the variable; it may have substitutions.
        kwargs: As for Action.
    """

    _attributes = (("name", "name"),)

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    @property
    def name(self) -> list[Substitution]:
        """Name of the variable to remove."""
        return self.__name

    def execute(self, context: LaunchContext) -> None:
        """Remove the variable, if it is set."""
        context.environment.pop(perform_substitutions(context, self.__name), None)


class PushEnvironment(Action):
    """Begins a scope: what is set from now on is undone by the next `PopEnvironment`."""

    def execute(self, context: LaunchContext) -> None:
        """Save a copy of the variables."""
        context._push_environment()


class PopEnvironment(Action):
    """Ends a scope: restores the environment variables of the last `PushEnvironment`."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the variables."""
        context._pop_environment()


@expose_action("reset_env")
class ResetEnvironment(ActionOfTexts):
    """Restores, when it is executed, the environment variables that the context was created with."""

    def execute(self, context: LaunchContext) -> None:
        """Restore the variables that the launch began with."""
        context._reset_environment()


@expose_action("rep_env")
class ReplaceEnvironmentVariables(Action):
    """Removes all environment variables when it is executed, and sets the given ones.

    In a launch file, the tag `rep_env` has a tag `env` for each, with `name` and `value`.

    Args:
        environment: Value of each variable, by its name. Both may have substitutions, which are performed before the
            others are removed.
        kwargs: As for Action.
    """

    def __init__(
        self,
        environment: Mapping[Any, SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__environment = [
            (normalize_to_list_of_substitutions(name), normalize_to_list_of_substitutions(value))
            for name, value in (environment or {}).items()
        ]

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions
    ) -> tuple[type[ReplaceEnvironmentVariables], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `rep_env`, which may hold tags `env`."""
        _, kwargs = super().parse(entity, parser)
        variables = entity.get_attr("env", data_type=list[Entity], optional=True)
        if variables is not None:
            kwargs["environment"] = dict(parse_pairs(variables, parser))
        return cls, kwargs

    @property
    def environment(self) -> list[tuple[list[Substitution], list[Substitution]]]:
        """Name and value of each variable."""
        return self.__environment

    def execute(self, context: LaunchContext) -> None:
        """Replace the variables for the processes that are started from here on."""
        context._replace_environment(
            {
                perform_substitutions(context, name): perform_substitutions(context, value)
                for name, value in self.__environment
            }
        )
