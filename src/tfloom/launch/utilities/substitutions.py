"""Substitutions in every form as a list, and the text of a list of them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from tfloom.launch.core.base_classes import (
    SomeSubstitutionsType,
    Substitution,
    SubstitutionFailure,
    TextSubstitution,
)
from tfloom.launch.core.launch_context import LaunchContext

__all__ = ["normalize_to_list_of_substitutions", "perform_some_substitutions", "perform_substitutions"]


MAX_CHARACTERS = 10_000_000
"""Length of the longest text of substitutions; that of a robot with all its meshes named has a tenth."""


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
        f"'{subs}' of type '{type(subs).__name__}' is neither a text nor a Substitution nor a list of them"
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


def perform_substitutions(context: LaunchContext, subs: Iterable[Substitution]) -> str:
    """Return the texts of substitutions, concatenated.

    Programs that have no launch pass None as the context, for substitutions of which none needs one.

    Raises:
        SubstitutionFailure: the text is longer than MAX_CHARACTERS, as by configurations that double one another.
    """
    texts, length = [], 0
    for substitution in subs:
        has_context: bool = context is not None
        texts.append(
            context.perform_substitution(substitution) if has_context else substitution.perform(context)
        )
        length += len(texts[-1])
        if length > MAX_CHARACTERS:
            raise SubstitutionFailure(
                f"the text of its substitutions is longer than {MAX_CHARACTERS} characters: "
                "does a value hold itself more than once?"
            )
    return "".join(texts)


def perform_some_substitutions(context: LaunchContext, subs: SomeSubstitutionsType) -> str:
    """Return the text of a text, a substitution, or a list of both."""
    return perform_substitutions(context, normalize_to_list_of_substitutions(subs))
