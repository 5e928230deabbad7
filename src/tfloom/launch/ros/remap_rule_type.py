"""Types of remappings: as launch files give them, and normalized."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution

__all__ = ["RemapRule", "RemapRules", "SomeRemapRule", "SomeRemapRules"]

SomeRemapRule = tuple[SomeSubstitutionsType, SomeSubstitutionsType]
"""A name and its replacement, as a launch file gives them."""

SomeRemapRules = Iterable[SomeRemapRule]

RemapRule = tuple[Sequence[Substitution], Sequence[Substitution]]
"""A name and its replacement, normalized."""

RemapRules = Iterable[RemapRule]
