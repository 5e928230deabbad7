"""A terminal's whole screen and its keys, given back as they were whatever ends the program."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from rich.color import ColorSystem
from rich.console import Console
from rich.style import Style

from tfloom.common.keyboard import Keyboard
from tfloom.common.terminal import CLEAR, HOME
from tfloom.tf2_tools.top.lines import Line

ENTER = "\x1b[?1049h\x1b[?25l\x1b[?7l"
"""To the other screen, without a cursor, without wrapping of long lines."""
LEAVE = "\x1b[?7h\x1b[?25h\x1b[?1049l"


class Screen:
    """The screen of a terminal, of which only lines that change are written.

    Args:
        output: File descriptor of the terminal.
    """

    def __init__(self, output: int) -> None:
        self._output = output
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
        # Another size of the screen leaves rests of the former lines: clear it. Otherwise write the changed lines
        # alone.
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

    def _styled(self, line: Line) -> str:
        if not line.style:
            return line.text
        if line.style not in self._styles:
            style = Style.parse(line.style)
            self._styles[line.style] = style if self._has_colors else style.without_color
        return self._styles[line.style].render(line.text, color_system=self._colors)

    def write(self, text: str) -> None:
        """Write to the terminal."""
        if sys.platform == "win32":  # the console takes UTF-16, by Python's own stream alone
            stream = sys.__stdout__
            if stream is not None:
                stream.write(text)
                stream.flush()
        else:  # not by `sys.stdout`, which shows control characters
            data = memoryview(text.encode("utf-8", "replace"))
            while data:
                data = data[os.write(self._output, data) :]

    def enter(self) -> None:
        """Begin with the other screen, empty."""
        if sys.platform == "win32":
            os.system("")  # noqa: S605 - an empty command has the console obey escape sequences from then on
        self.write(ENTER + CLEAR + HOME)
        self._drawn = []

    def leave(self) -> None:
        """Show the screen that was there before."""
        self.write(LEAVE)


COLORS = {
    None: None,
    "standard": ColorSystem.STANDARD,
    "256": ColorSystem.EIGHT_BIT,
    "truecolor": ColorSystem.TRUECOLOR,
    "windows": ColorSystem.WINDOWS,
}


@contextmanager
def whole_screen(output: int, keys: int) -> Iterator[tuple[Screen, Keyboard]]:
    """Use the terminal's other screen, and its keys one by one, for the block.

    Ctrl-C raises KeyboardInterrupt as otherwise. Ctrl-Z gives the terminal back until the program continues.

    Args:
        output: File descriptor of the terminal.
        keys: File descriptor from which keys are read.
    """
    screen = Screen(output)
    with Keyboard(keys, screen.enter, screen.leave) as keyboard:
        yield screen, keyboard
