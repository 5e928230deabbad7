"""Remove an environment variable."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions

__all__ = ["UnsetEnvironmentVariable"]


@expose_action("unset_env")
class UnsetEnvironmentVariable(Action):
    """Removes an environment variable, when it is executed; one that isn't set is no error.

    Args:
        name: Name of the variable; it may have substitutions.
        kwargs: As for Action.
    """

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions
    ) -> tuple[type[UnsetEnvironmentVariable], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `unset_env`: `name`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["name"] = parser.parse_substitution(entity.get_attr("name"))
        return cls, kwargs

    @property
    def name(self) -> list[Substitution]:
        """The name."""
        return self.__name

    def execute(self, context: LaunchContext) -> None:
        """Remove it."""
        context.environment.pop(perform_substitutions(context, self.__name), None)
