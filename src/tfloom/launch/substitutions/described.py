"""The description of several substitutions."""

from __future__ import annotations

from collections.abc import Iterable

from tfloom.launch.substitution import Substitution

__all__ = ["described"]


def described(substitutions: Iterable[Substitution]) -> str:
    """Return the descriptions of substitutions that are concatenated."""
    return " + ".join(substitution.describe() for substitution in substitutions)
