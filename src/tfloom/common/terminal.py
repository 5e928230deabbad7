r"""Text from messages, names and files on a terminal: control characters are shown, not obeyed.

A string of a message may hold a sequence that clears the screen, moves the cursor, sets the window's title, or
reverses the direction of a line. On a terminal such characters appear as escape sequences of Python (`\x1b`,
`\u202e`). A pipe or a file gets the text as it is.
"""

from __future__ import annotations

import atexit
import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, TextIO

__all__ = [
    "TerminalOutput",
    "drop_unwritten",
    "has_browser",
    "is_terminal",
    "report",
    "shown",
    "shown_in_colors",
    "shown_name",
    "shown_on_terminals",
    "shown_part",
    "unescaped",
]

# C0 without tab and line feed, DEL, C1, and the embeddings, overrides and isolates of bidirectional text.
_OBEYED = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")

_COLORS = re.compile(r"(\x1b\[[0-9;:]*m)")  # ECMA-48's SGR: colours, bold and the like
_RESET = "\x1b[0m"
MAX_NAME = 200
"""The longest part of a name that is shown of one from a hostile program."""


def _escape(match: re.Match[str]) -> str:
    code = ord(match.group())
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}"


def has_browser() -> bool:
    """Return whether a browser would be seen: there is a screen, or BROWSER names one, and it is not a run of a CI."""
    has_screen = (
        sys.platform in {"win32", "darwin"} or {"BROWSER", "DISPLAY", "WAYLAND_DISPLAY"} & os.environ.keys()
    )
    return bool(has_screen) and "CI" not in os.environ


def shown(text: str) -> str:
    """Return a text in which each character that a terminal would obey is an escape sequence; tabs and lines stay."""
    return _OBEYED.sub(_escape, text)


def shown_in_colors(line: str) -> str:
    """Return a line as `shown` does, but with its colours, which end with the line."""
    texts_and_colors = _COLORS.split(line)
    colors = texts_and_colors[1::2]
    texts_and_colors[::2] = map(shown, texts_and_colors[::2])
    is_open = bool(colors) and colors[-1] not in {_RESET, "\x1b[m"}
    return "".join(texts_and_colors) + (_RESET if is_open else "")


def shown_name(name: str) -> str:
    """Return a name, which is on one line: as `shown`, but tabs and line feeds are escape sequences, too."""
    return shown(name).replace("\n", "\\x0a").replace("\t", "\\x09")


def report(text: object) -> None:
    """Print a text on stderr. Where that can't be written, as to a full disk or a closed pipe, it is lost.

    Without a stderr, `print` would write it among the results, on stdout.
    """
    if sys.stderr is not None:
        try:
            print(text, file=sys.stderr)
        except OSError:
            # Its buffer keeps the text, and the interpreter's exit would fail to write it: exit code 120.
            atexit.unregister(_drop_what_stderr_refuses)
            atexit.register(_drop_what_stderr_refuses)
        except ValueError:  # it is closed
            pass


def _drop_what_stderr_refuses() -> None:
    """Drop what stderr still can't write."""
    if sys.stderr is not None:
        try:
            sys.stderr.flush()
        except OSError:
            drop_unwritten(sys.stderr)
        except ValueError:  # it is closed
            pass


def drop_unwritten(stream: TextIO | None) -> None:
    """Drop what a standard stream holds and could not write, or the interpreter's exit would try again, and fail."""
    if stream is not None:
        with suppress(
            OSError, ValueError
        ):  # it has no descriptor, or is closed; or the process has none left
            null = os.open(os.devnull, os.O_WRONLY)
            try:
                os.dup2(null, stream.fileno())
            finally:
                os.close(null)


def shown_part(name: str) -> str:
    """Return the beginning of a name of any length, as `shown_name` does."""
    return shown_name(name if len(name) <= MAX_NAME else f"{name[:MAX_NAME]}…")


def is_terminal(stream: object) -> bool:
    """Return whether an output stream is a terminal."""
    isatty = getattr(stream, "isatty", None)
    try:
        return isatty is not None and bool(isatty())
    except ValueError:  # it is closed
        return False


class TerminalOutput:
    """A terminal's stream whose `write` shows what the terminal would obey; all else is the stream's.

    Args:
        stream: The stream.
    """

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream

    def write(self, text: str) -> int:
        """Write a text, and return its length."""
        self.stream.write(shown(text))
        return len(text)

    def writelines(self, lines: Any) -> None:
        """Write each of the lines."""
        for line in lines:
            self.write(line)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


HOME = "\x1b[H"
"""To the upper left corner."""
CLEAR = "\x1b[2J"
"""Nothing on the screen."""


def clear_terminal(stream: Any) -> None:
    """Clear the screen if a stream is a terminal, and go to its first line."""
    if is_terminal(stream):
        unescaped(stream).write(CLEAR + HOME)


def unescaped(stream: Any) -> Any:
    """Return the stream below a `TerminalOutput`, for text with colours of our own; else the stream itself."""
    return stream.stream if isinstance(stream, TerminalOutput) else stream


@contextmanager
def shown_on_terminals() -> Iterator[None]:
    """Within the block, `sys.stdout` and `sys.stderr` show control characters where they are terminals."""
    names = [name for name in ("stdout", "stderr") if _obeys(getattr(sys, name))]
    for name in names:
        setattr(sys, name, TerminalOutput(getattr(sys, name)))
    try:
        yield
    finally:
        for name in names:
            setattr(sys, name, unescaped(getattr(sys, name)))


def _obeys(stream: object) -> bool:
    return is_terminal(stream) and not isinstance(stream, TerminalOutput)
