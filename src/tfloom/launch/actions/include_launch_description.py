"""Include a launch description, such as another launch file."""

from __future__ import annotations

import os.path
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from tfloom.launch.actions.launch_configurations import SetLaunchConfiguration
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeSubstitutionsType
from tfloom.launch.core.circular_includes import refuse_circle
from tfloom.launch.core.entity import Entity, ParsesActions, parse_pairs
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.entities.launch_description_source import LaunchDescriptionSource
from tfloom.launch.files.sources import AnyLaunchDescriptionSource
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.utilities.argument_errors import substitutions_error
from tfloom.launch.utilities.substitutions import perform_some_substitutions

__all__ = ["IncludeLaunchDescription"]

_FILE = "current_launch_file_path"
_FOLDER = "current_launch_file_directory"

Argument = tuple[SomeSubstitutionsType, SomeSubstitutionsType]


@expose_action("include")
class IncludeLaunchDescription(Action):
    """Visits the entities of another launch description, with arguments, when it is executed.

    The arguments become launch configurations, also those that the description doesn't declare. They last to the end of
    the scope that includes it, as do those that the description sets.

    Args:
        launch_description_source: The source of the description, or the path of a launch file, of any format, which
            may have substitutions.
        launch_arguments: Name and value of each argument; both may have substitutions.
        kwargs: As for Action.

    Raises:
        TypeError: `launch_arguments` is a dictionary, whose items would be needed.
    """

    def __init__(
        self,
        launch_description_source: LaunchDescriptionSource | SomeSubstitutionsType,
        *,
        launch_arguments: Iterable[Argument] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        if not isinstance(launch_description_source, LaunchDescriptionSource):
            if (
                error := substitutions_error("launch_description_source", launch_description_source)
            ) is not None:
                raise error
            launch_description_source = AnyLaunchDescriptionSource(launch_description_source)
        self.__launch_description_source = launch_description_source
        if isinstance(launch_arguments, Mapping):
            raise TypeError(
                "launch_arguments is a dictionary: give its items, `launch_arguments={...}.items()`"
            )
        self.__launch_arguments = tuple(launch_arguments or ())
        self._outer_places: list[dict[str, Any]] = []
        """For each visit that has not ended: the place of the file that includes, once it is another one."""

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions
    ) -> tuple[type[IncludeLaunchDescription], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `include`.

        It has a `file`, and may have tags `arg` or `let`, each with `name` and `value`.
        """
        _, kwargs = super().parse(entity, parser)
        kwargs["launch_description_source"] = parser.parse_substitution(entity.get_attr("file"))
        arguments: list[Entity] = []
        for tag in ("arg", "let"):
            arguments += entity.get_attr(tag, data_type=list[Entity], optional=True) or []
        if arguments:
            kwargs["launch_arguments"] = parse_pairs(arguments, parser)
        return cls, kwargs

    @property
    def launch_description_source(self) -> LaunchDescriptionSource:
        """The source of the description."""
        return self.__launch_description_source

    @property
    def launch_arguments(self) -> tuple[Argument, ...]:
        """Name and value of each argument."""
        return self.__launch_arguments

    def describe(self) -> str:
        """Return the class's name with the location of the description."""
        return f"IncludeLaunchDescription({self.__launch_description_source.location})"

    def location_without_context(self) -> str | None:
        """Return the absolute path of the file, or None if it isn't known before the launch, or there is no file."""
        location = self.__launch_description_source.location_without_context()
        return _absolute(location) if location is not None and Path(location).exists() else None

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the description, if it can be loaded before the launch; else nothing."""
        description = self.__launch_description_source.try_get_launch_description_without_context()
        return [] if description is None else [description]

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Execute the action if its condition holds."""
        self._outer_places.append({})
        try:
            return super().visit(context)
        except BaseException:
            self.end_visit(context)
            raise

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Load the description, and return it after the settings of its arguments.

        Raises:
            RuntimeError: an argument that the description declares has no value.
            CircularIncludeError: a file includes itself endlessly.
            Exception: the description can't be loaded.
        """
        before = context.get_locals_as_dict()
        description = self.__launch_description_source.get_launch_description(context)
        location = self.__launch_description_source.location
        path = _absolute(location)
        is_file = Path(path).exists()  # otherwise it is the name of a script's description
        if is_file:
            refuse_circle(context, path)
        context.extend_locals({_FILE: path, _FOLDER: str(Path(path).parent) if is_file else location})
        if self._outer_places:  # else `execute` was called without a visit
            self._outer_places[-1] = {name: before.get(name) for name in (_FILE, _FOLDER)}
        self._check_arguments(context, description)
        return [
            *(SetLaunchConfiguration(name, value) for name, value in self.__launch_arguments),
            description,
        ]

    def end_visit(self, context: LaunchContext) -> None:
        """Return to the place of the file that includes."""
        # A subclass with a `visit` that doesn't call this class's has none.
        places = self._outer_places.pop() if self._outer_places else {}
        for name, value in places.items():
            context.remove_local(name)
            if value is not None:
                context.extend_locals({name: value})

    def _check_arguments(self, context: LaunchContext, description: LaunchDescription) -> None:
        """Raise RuntimeError if an argument that is certainly used has no value; others may fail when they are used."""
        given_names = [perform_some_substitutions(context, name) for name, _ in self.__launch_arguments]
        declarations = description.get_launch_arguments_with_include_launch_description_actions()
        for argument, inclusions in declarations:
            is_optional = argument._conditionally_included
            is_set = argument.name in context.launch_configurations
            if is_set or is_optional or argument.default_value is not None:
                continue
            inner = {name for inclusion in inclusions or () for name in inclusion.known_argument_names()}
            if argument.name not in given_names and argument.name not in inner:
                raise RuntimeError(
                    f"Included launch description missing required argument '{argument.name}' "
                    f"(description: '{argument.description}'), given: [{', '.join(given_names)}]"
                )

    def known_argument_names(self) -> list[str]:
        """Return the names of the arguments that need no context."""
        context = LaunchContext()
        names = []
        for name, _ in self.__launch_arguments:
            with suppress(Exception):  # any that a substitution raises without a context
                names.append(perform_some_substitutions(context, name))
        return names


def _absolute(path: str) -> str:
    return os.path.abspath(path)  # noqa: PTH100  # symbolic links are not resolved: they lead to a file's neighbours
