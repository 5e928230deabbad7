"""Declare an argument of a launch description."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["DeclareBooleanLaunchArgument", "DeclareLaunchArgument"]

_LOGGER_NAME = "launch.actions.declare_launch_argument"


@expose_action("arg")
class DeclareLaunchArgument(Action):
    """Declares an argument of the launch description, which becomes a launch configuration of the same name.

    A command line (`name:=value`) or an `IncludeLaunchDescription` gives its value. A declaration that is inside a
    condition, or an event handler's, is found as far as the description can be read without running it.

    Args:
        name: Name of the argument.
        default_value: Value if none is given; it may have substitutions. None: a value must be given.
        description: What the argument is for.
        choices: The valid values; None: any.
        kwargs: As for Action.

    Raises:
        RuntimeError: there are no choices in `choices`, or `default_value` is a text that isn't one of them.
    """

    declares_argument = True
    """For LaunchDescription, which searches for the declarations."""

    def __init__(
        self,
        name: str,
        *,
        default_value: SomeSubstitutionsType | None = None,
        description: str | None = None,
        choices: Sequence[str] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__name = name
        self.__default_value = (
            None if default_value is None else normalize_to_list_of_substitutions(default_value)
        )
        if choices is not None:
            choices = list(choices)
            _check_choices(choices, default_value)
        self.__choices = choices
        self.__description = _describe(description, choices)
        self._conditionally_included = False
        """Whether it may not be executed: set by the search for the arguments of a description."""

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions
    ) -> tuple[type[DeclareLaunchArgument], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `arg`.

        It has a `name`, and may have `default`, `description` and tags `choice`, each with a `value`.
        """
        _, kwargs = super().parse(entity, parser)
        kwargs["name"] = parser.escape_characters(entity.get_attr("name"))
        default = entity.get_attr("default", optional=True)
        if default is not None:
            kwargs["default_value"] = parser.parse_substitution(default)
        description = entity.get_attr("description", optional=True)
        if description is not None:
            kwargs["description"] = parser.escape_characters(description)
        choices = entity.get_attr("choice", data_type=list[Entity], optional=True)
        if choices is not None:
            kwargs["choices"] = [parser.escape_characters(choice.get_attr("value")) for choice in choices]
        return cls, kwargs

    @property
    def name(self) -> str:
        """Name of the argument, as on the command line before `:=`."""
        return self.__name

    @property
    def default_value(self) -> list[Substitution] | None:
        """The value if none is given, or None."""
        return self.__default_value

    @property
    def description(self) -> str:
        """What the argument is for, and the valid values."""
        return self.__description

    @property
    def choices(self) -> list[str] | None:
        """The valid values, or None."""
        return self.__choices

    def execute(self, context: LaunchContext) -> None:
        """Set the launch configuration to the default if no value was given.

        Raises:
            RuntimeError: no value was given and there is no default, or the value isn't one of the choices.
        """
        context.declared_arguments.append(self.__name)
        configurations = context.launch_configurations
        if self.__name not in configurations:
            if self.__default_value is None:
                get_logger(_LOGGER_NAME).error(
                    f'Required launch argument "{self.__name}" (description: "{self.__description}") '
                    "was not provided"
                )
                raise RuntimeError(f'Required launch argument "{self.__name}" was not provided.')
            configurations[self.__name] = perform_substitutions(context, self.__default_value)
        if self.__choices is not None and (value := configurations[self.__name]) not in self.__choices:
            raise _logged_error(
                f'Argument "{self.__name}" provided value "{value}" is not valid. '
                f"Valid options are: {self.__choices}"
            )


@expose_action("bool_arg")
class DeclareBooleanLaunchArgument(DeclareLaunchArgument):
    """Declares an argument whose valid values are those of a boolean: true, false, True, False, TRUE, FALSE.

    Args:
        name: Name of the argument.
        default_value: Value if none is given: a boolean, or a text, which may have substitutions. None: a value must
            be given.
        description: What the argument is for.
        kwargs: As for Action.

    Raises:
        RuntimeError: `default_value` is a text that isn't one of the valid values.
        ValueError: there are `choices`, here or as tags in a launch file.
    """

    CHOICES = ("true", "false", "True", "False", "TRUE", "FALSE")

    def __init__(
        self,
        name: str,
        *,
        default_value: bool | SomeSubstitutionsType | None = None,
        description: str | None = None,
        **kwargs: Any,
    ) -> None:
        if "choices" in kwargs:
            raise ValueError("Cannot specify choices for bool_arg")
        super().__init__(
            name,
            default_value=str(default_value).lower() if isinstance(default_value, bool) else default_value,
            description=description,
            choices=self.CHOICES,
            **kwargs,
        )


def _check_choices(choices: list[str], default_value: SomeSubstitutionsType | None) -> None:
    if not choices:
        raise _logged_error("Provided choices arg is empty. Use None to ignore the choice list.")
    if isinstance(default_value, str) and default_value not in choices:
        raise _logged_error(
            f'Provided default_value "{default_value}" is not in provided choices "{choices}".'
        )


def _describe(description: str | None, choices: list[str] | None) -> str:
    if choices is None:
        return "no description given" if description is None else description
    if description is None:
        return f"One of: {choices}"
    return f"{description}{'' if description.endswith('.') else '.'} Valid choices are: {choices}"


def _logged_error(text: str) -> RuntimeError:
    get_logger(_LOGGER_NAME).error(text)
    return RuntimeError(text)
