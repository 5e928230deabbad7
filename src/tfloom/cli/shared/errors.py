"""Errors that end a command with a message instead of a traceback."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from typing import TextIO


class CommandError(Exception):
    """The command can't be executed; the text, for the user, has the reason."""

    def __init__(self, text: str, exit_code: int = 1) -> None:
        super().__init__(text)
        self.exit_code = exit_code


def standard_input() -> TextIO:
    """Return standard input.

    Raises:
        CommandError: it is closed.
    """
    if sys.stdin is None:
        raise CommandError("standard input is closed")
    return sys.stdin


def refuse_bytes(words: Sequence[str]) -> None:
    """Raise CommandError if a word isn't text: Python decodes invalid bytes to lone surrogates."""
    for word in words:
        if any("\ud800" <= letter <= "\udfff" for letter in word):
            raise CommandError(f"the argument {os.fsencode(word)!r} isn't text in this terminal's encoding")
