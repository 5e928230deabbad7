"""Elements that hold two texts, as `<arg name="…" value="…"/>`."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.substitution import Substitution

__all__ = ["Pair", "parse_pairs"]

Pair = tuple[tuple[Substitution, ...], list[Substitution]]


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
