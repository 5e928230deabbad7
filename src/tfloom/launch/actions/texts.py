"""The base classes of actions whose attributes in launch files are texts."""

from __future__ import annotations

from typing import Any, ClassVar

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.entities.action import Action
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions

__all__ = ["ActionOfTexts", "NamedValue"]


class ActionOfTexts(Action):
    """An action whose attributes in launch files are required, and are texts that may have substitutions."""

    _attributes: ClassVar[tuple[tuple[str, str], ...]] = ()
    """Arguments of the constructor, each with the name of its attribute."""

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor."""
        _, kwargs = super().parse(entity, parser)
        for argument, attribute in cls._attributes:
            kwargs[argument] = parser.parse_substitution(entity.get_attr(attribute))
        return cls, kwargs


class NamedValue(ActionOfTexts):
    """Sets a value by its name when it is executed, as derived classes define.

    Args:
        name: The name; it may have substitutions.
        value: The value; it may have substitutions.
        kwargs: As for Action.
    """

    _attributes = (("name", "name"), ("value", "value"))

    def __init__(self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = normalize_to_list_of_substitutions(value)

    @property
    def name(self) -> list[Substitution]:
        """Name of what is set, as substitutions."""
        return self.__name

    @property
    def value(self) -> list[Substitution]:
        """Value that it gets, as substitutions."""
        return self.__value
