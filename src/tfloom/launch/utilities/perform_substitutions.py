"""The text of several substitutions."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.substitution_failure import SubstitutionFailure
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions

__all__ = ["perform_some_substitutions", "perform_substitutions"]


MAX_CHARACTERS = 10_000_000
"""Length of the longest text of substitutions; that of a robot with all its meshes named has a tenth."""


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
