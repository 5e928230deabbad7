"""The base class of actions that set a value by a name."""

from __future__ import annotations

from typing import Any

from tfloom.launch.action import Action
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions

__all__ = ["NamedValue"]


class NamedValue(Action):
    """Sets a value by its name when it is executed, as derived classes define.

    Args:
        name: The name; it may have substitutions.
        value: The value; it may have substitutions.
        kwargs: As for Action.
    """

    def __init__(self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = normalize_to_list_of_substitutions(value)

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and its arguments, read from a tag: `name` and `value`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["name"] = parser.parse_substitution(entity.get_attr("name"))
        kwargs["value"] = parser.parse_substitution(entity.get_attr("value"))
        return cls, kwargs

    @property
    def name(self) -> list[Substitution]:
        """Name of what is set, as substitutions."""
        return self.__name

    @property
    def value(self) -> list[Substitution]:
        """Value that it gets, as substitutions."""
        return self.__value
