"""A text as a substitution."""

from __future__ import annotations

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.substitution import Substitution

__all__ = ["TextSubstitution"]


class TextSubstitution(Substitution):
    """A text.

    Args:
        text: The text itself.

    Raises:
        TypeError: `text` is not a text.
    """

    def __init__(self, *, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(f"TextSubstitution expected Text object got '{type(text)}' instead.")
        self._text = text

    @property
    def text(self) -> str:
        """Text that the substitution stands for, whatever the context."""
        return self._text

    def describe(self) -> str:
        """Return a description for people."""
        return f"'{self._text}'"

    def perform(self, context: LaunchContext) -> str:
        """Return the text."""
        return self._text
