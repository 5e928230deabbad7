"""What an argument accepts where it takes substitutions: a text, a substitution, or a list of both, concatenated."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Union

from tfloom.launch.substitution import Substitution

__all__ = ["SomeSubstitutionsType", "SomeSubstitutionsType_types_tuple"]

SomeSubstitutionsType = Union[str, Substitution, Iterable[str | Substitution]]

SomeSubstitutionsType_types_tuple = (str, Substitution, Iterable)
"""The same for `isinstance`."""
