"""The ends of a command: errors with a message instead of a traceback, and Ctrl-C."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Sequence
from typing import NoReturn, TextIO


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


LOOK_S = 0.25
"""How late Ctrl-C may be noticed [s]."""


def wait_for_ctrl_c() -> NoReturn:
    """Wait on the main thread until the handler of a signal raises.

    Raises:
        KeyboardInterrupt: Ctrl-C.
    """
    while True:
        # Python runs handlers between two steps of the main thread. A wait without an end would miss a signal that
        # comes just before it, or on another thread: only one that comes within it, on this thread, ends it.
        time.sleep(LOOK_S)
