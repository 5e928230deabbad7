"""Imports that Ctrl-C ends without a traceback: those of a command take a part of a second."""

from __future__ import annotations

import os
import signal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import FrameType

__all__ = ["INTERRUPTED", "QuietImports"]

INTERRUPTED = 2
"""Exit code after Ctrl-C, as in ros2."""


class QuietImports:
    """A block of imports at the start of a program, in which Ctrl-C ends the process at once, without a traceback.

    A KeyboardInterrupt would be no substitute: Python makes other errors of one that is raised within some imports.
    """

    def __enter__(self) -> None:
        self._former = signal.getsignal(signal.SIGINT)
        # It is left alone where it is ignored, as in background jobs, or handled by somebody else.
        if self._former is signal.default_int_handler:
            signal.signal(signal.SIGINT, _end_at_once)

    def __exit__(self, *_: object) -> None:
        if self._former is signal.default_int_handler:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def _end_at_once(_number: int, _frame: FrameType | None) -> None:
    # An exit as usual would run what modules, imported in part, have registered for it. Nothing has been printed yet.
    os._exit(INTERRUPTED)
