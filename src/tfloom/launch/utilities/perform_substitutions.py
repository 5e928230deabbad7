"""The text of several substitutions."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.substitution import Substitution

__all__ = ["perform_substitutions"]


def perform_substitutions(context: LaunchContext, subs: Iterable[Substitution]) -> str:
    """Return the texts of substitutions, concatenated."""
    return "".join(context.perform_substitution(each) for each in subs)
