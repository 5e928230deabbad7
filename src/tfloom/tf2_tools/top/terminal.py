"""A terminal's whole screen and its keys, given back as they were whatever ends the program."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from rich.color import ColorSystem
from rich.console import Console
from rich.style import Style

from tfloom.tf2_tools.top import keys as terminal_keys
from tfloom.tf2_tools.top.lines import Line

ENTER = "\x1b[?1049h\x1b[?25l\x1b[?7l"
"""To the other screen, without a cursor, without wrapping of long lines."""
LEAVE = "\x1b[?7h\x1b[?25h\x1b[?1049l"
HOME = "\x1b[H"
CLEAR = "\x1b[2J"
ESCAPE_S = 0.05
"""Time after an escape character within which the rest of a key's sequence comes [s]."""
NAMES = {
    "\x1b[A": "up",
    "\x1b[B": "down",
    "\x1bOA": "up",
    "\x1bOB": "down",
    "\x1b[5~": "page up",
    "\x1b[6~": "page down",
    "\x1b[H": "home",
    "\x1b[F": "end",
    "\x1b[1~": "home",
    "\x1b[4~": "end",
    "\x1b": "escape",
    "\r": "enter",
    "\n": "enter",
    "\x7f": "backspace",
    "\b": "backspace",
    "\x15": "clear",
}


class Screen:
    """The screen of a terminal, of which only lines that change are written.

    Args:
        output: File descriptor of the terminal.
        keys: File descriptor from which keys are read.
    """

    def __init__(self, output: int, keys: int) -> None:
        self._output = output
        self._keys = keys
        console = Console(file=sys.__stdout__)
        self._colors = COLORS[console.color_system]
        self._has_colors = not console.no_color
        self._drawn: list[Line] = []
        self._styles: dict[str, Style] = {}

    def size(self) -> tuple[int, int]:
        """Return columns and lines."""
        columns, lines = os.get_terminal_size(self._output)
        return max(columns, 1), max(lines, 1)

    def draw(self, lines: Sequence[Line]) -> None:
        """Show these lines from the upper left corner, each as wide as the screen."""
        is_new = len(lines) != len(self._drawn) or any(
            len(one.text) != len(other.text) for one, other in zip(lines, self._drawn, strict=False)
        )
        parts = [CLEAR] if is_new else []
        for i, line in enumerate(lines):
            if is_new or line != self._drawn[i]:
                parts.append(f"\x1b[{i + 1};1H{self._styled(line)}")
        self._drawn = list(lines)
        if parts:
            self.write("".join(parts))

    def forget(self) -> None:
        """Draw all lines next time."""
        self._drawn = []

    def _styled(self, line: Line) -> str:
        if not line.style:
            return line.text
        if line.style not in self._styles:
            style = Style.parse(line.style)
            self._styles[line.style] = style if self._has_colors else style.without_color
        return self._styles[line.style].render(line.text, color_system=self._colors)

    def write(self, text: str) -> None:
        """Write to the terminal: not by `sys.stdout`, which shows control characters."""
        terminal_keys.write(self._output, text)

    def read_keys(self, end_s: float) -> list[str]:
        """Wait for keys until `end_s` on the monotonic clock [s]; return their names, none at the end.

        When the terminal has been closed, the key is `q`.
        """
        if not self._wait(end_s - time.monotonic()):
            return []
        data = terminal_keys.read(self._keys)
        if not data:
            return ["q"]
        while data.endswith(b"\x1b") and self._wait(ESCAPE_S):
            data += terminal_keys.read(self._keys)
        return key_names(data.decode("utf-8", "ignore"))

    def _wait(self, timeout_s: float) -> bool:
        return terminal_keys.wait(self._keys, max(0.0, timeout_s))


COLORS = {
    None: None,
    "standard": ColorSystem.STANDARD,
    "256": ColorSystem.EIGHT_BIT,
    "truecolor": ColorSystem.TRUECOLOR,
    "windows": ColorSystem.WINDOWS,
}


def key_names(text: str) -> list[str]:
    """Return the names of the keys that a terminal sent as one text."""
    names = []
    while text:
        length = next((n for n in (4, 3) if text[:n] in NAMES), 1)
        if length == 1 and text.startswith(("\x1b[", "\x1bO")):  # the sequence of another key
            end = next(
                (i for i, letter in enumerate(text[2:], 2) if letter.isalpha() or letter == "~"),
                len(text) - 1,
            )
            text = text[end + 1 :]
            continue
        names.append(NAMES.get(text[:length], text[:length]))
        text = text[length:]
    return names


@contextmanager
def whole_screen(output: int, keys: int) -> Iterator[Screen]:
    """Use the terminal's other screen, and its keys one by one, for the block.

    Ctrl-C raises KeyboardInterrupt as otherwise. Ctrl-Z gives the terminal back until the program continues.
    """
    screen = Screen(output, keys)

    def enter() -> None:
        screen.write(ENTER + CLEAR + HOME)
        screen.forget()

    with terminal_keys.single(keys, enter, lambda: screen.write(LEAVE)):
        yield screen
