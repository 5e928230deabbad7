"""The text of several substitutions."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions

__all__ = ["perform_some_substitutions", "perform_substitutions"]


def perform_substitutions(context: LaunchContext, subs: Iterable[Substitution]) -> str:
    """Return the texts of substitutions, concatenated."""
    return "".join(context.perform_substitution(each) for each in subs)


def perform_some_substitutions(context: LaunchContext, subs: SomeSubstitutionsType) -> str:
    """Return the text of a text, a substitution, or a list of both."""
    return perform_substitutions(context, normalize_to_list_of_substitutions(subs))
