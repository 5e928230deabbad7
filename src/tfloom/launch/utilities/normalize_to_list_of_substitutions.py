"""Substitutions in every form as a list."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.text_substitution import TextSubstitution

__all__ = ["normalize_to_list_of_substitutions"]


def normalize_to_list_of_substitutions(subs: SomeSubstitutionsType) -> list[Substitution]:
    """Return the substitutions of a text, a substitution, a path, or a list of them.

    Raises:
        TypeError: it is, or holds, something else.
    """
    if isinstance(subs, (str, Path, Substitution)):
        return [_as_substitution(subs)]
    if isinstance(subs, Iterable):
        return [_as_substitution(part) for part in subs]
    raise TypeError(
        f"'{subs}' of type '{type(subs).__name__}' is no text, no Substitution, and no list of them"
    )


def _as_substitution(value: Any) -> Substitution:
    if isinstance(value, Substitution):
        return value
    if isinstance(value, (str, Path)):
        return TextSubstitution(text=str(value))
    raise TypeError(
        "Failed to normalize given item of type "
        f"'{type(value)}', when only 'str' or 'launch.Substitution' were expected."
    )
