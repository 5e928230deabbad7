"""An element of a launch file, those that hold two texts, and the parser as actions need it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol, TypeVar

from tfloom.launch.core.base_classes import Condition, Substitution

__all__ = ["Entity", "Pair", "ParsesActions", "TargetType", "parse_pairs"]

TargetType = TypeVar("TargetType")


class Entity:
    """An element of a launch file, in any of its languages."""

    @property
    def type_name(self) -> str:
        """Name of the element."""
        raise NotImplementedError

    @property
    def parent(self) -> Entity | None:
        """Element that this one is in."""
        raise NotImplementedError

    @property
    def children(self) -> list[Entity]:
        """Elements in this one."""
        raise NotImplementedError

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError if the element has attributes or children that have not been read."""
        raise NotImplementedError

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """Return an attribute.

        Args:
            name: Its name.
            data_type: str, int, float, bool, a list of one of them (`List[int]`), or `List[Entity]` for children of
                that name; None: what its text looks like.
            optional: Whether it may be missing, and None is returned.
            can_be_str: Whether a text is returned where it has no value of the type, as for substitutions.

        Raises:
            AttributeError: it is missing.
            TypeError: it has another type.
        """
        raise NotImplementedError


class ParsesActions(Protocol):
    """The parser, as an action's `parse` needs it."""

    def parse_condition(self, entity: Entity) -> Condition | None:
        """Return the condition of the attributes `if` and `unless`."""

    def parse_substitution(self, value: str) -> list[Substitution]:
        """Return the substitutions of a text."""

    def parse_if_substitutions(self, value: Any) -> Any:
        """Return the substitutions of a value if it is a text or a list of texts, else the value."""

    def parse_action(self, entity: Entity) -> Any:
        """Return the action of an element."""

    def escape_characters(self, value: str) -> str:
        """Return a text with backslash escapes replaced."""

    def get_file_extensions(self) -> set[str]:
        """Return the extensions of the files that it reads."""


Pair = tuple[tuple[Substitution, ...], list[Substitution]]
"""The two texts of an element, as `<arg name="…" value="…"/>`."""


def parse_pairs(
    entities: Iterable[Entity], parser: ParsesActions, first: str = "name", second: str = "value"
) -> list[Pair]:
    """Return the substitutions of two attributes of each element, which has no others.

    Args:
        entities: The elements.
        parser: The parser of their file.
        first: Name of the first attribute.
        second: Name of the second attribute.
    """
    pairs = []
    for entity in entities:
        name = tuple(parser.parse_substitution(entity.get_attr(first)))
        pairs.append((name, parser.parse_substitution(entity.get_attr(second))))
        entity.assert_entity_completely_parsed()
    return pairs
