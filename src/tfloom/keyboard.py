"""Single key presses from a terminal, whose mode is always restored at the program's end."""

from __future__ import annotations

import os
import re
import signal
import sys
from collections.abc import Callable
from types import FrameType, TracebackType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing_extensions import Self

ARROWS = {"A": "up", "B": "down", "C": "right", "D": "left"}
# An arrow as terminals send it: plain, in application mode, with a modifier key held.
_KEY = re.compile(
    r"\x1b(?:\[[\d;]*|O)(?P<arrow>[A-D])|\x1b\[[\d;?]*[@-~]|\x1b[O[].?|(?P<letter>.)", re.DOTALL
)
_UNFINISHED = re.compile(r"\x1b(?:[O[][\d;?]*)?\Z")
ESCAPE_WAIT_S = 0.05
"""The longest wait for the rest of an arrow key's sequence."""


class NoTerminalError(Exception):
    """Standard input is not a terminal, so single keys can't be read from it."""


def decode_keys(text: str) -> list[str]:
    """Return the keys in a terminal's input: `up`, `down`, `left`, `right` or a letter.

    A repeated key is returned once, because a terminal repeats a key that is held down, and accumulated repetitions
    must be dropped. Sequences of other keys are ignored.
    """
    keys: list[str] = []
    for match in _KEY.finditer(text):
        key = ARROWS.get(match["arrow"] or "") or match["letter"]
        if key and key != "\x1b" and keys[-1:] != [key]:
            keys.append(key)
    return keys


if sys.platform != "win32":
    import select
    import termios

    class Keyboard:
        """Key presses on standard input, which must be a terminal; a context manager that sets and restores its mode.

        Ctrl-C remains a signal. Hang-up and quit end the program by SystemExit; a stop (Ctrl-Z) restores the
        mode until the program continues. To be entered in the main thread.
        """

        def __init__(self) -> None:
            self._fd = 0
            self._handlers: dict[int, Callable[[int, FrameType | None], object] | int | None] = {}

        def __enter__(self) -> Self:
            if not os.isatty(self._fd):
                raise NoTerminalError
            self._found = termios.tcgetattr(self._fd)
            for number, handler in {
                signal.SIGHUP: _exit_on_signal,
                signal.SIGQUIT: _exit_on_signal,
                signal.SIGTSTP: self._stop,
            }.items():
                self._handlers[number] = signal.signal(number, handler)
            self._set_mode()
            return self

        def __exit__(
            self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
        ) -> None:
            self._restore_mode()
            for number, handler in self._handlers.items():
                signal.signal(number, handler)

        def read(self, timeout_s: float) -> list[str]:
            """Wait for keys and return all that were pressed; empty after the timeout.

            Raises:
                EOFError: the terminal is closed.
            """
            if not select.select([self._fd], [], [], timeout_s)[0]:
                return []
            text = self._read_text()
            while _UNFINISHED.search(text) and select.select([self._fd], [], [], ESCAPE_WAIT_S)[0]:
                text += self._read_text()
            return decode_keys(text)

        def _read_text(self) -> str:
            try:
                data = os.read(self._fd, 4096)
            except OSError:
                data = b""
            if not data:
                raise EOFError
            return data.decode("utf-8", "replace")

        def _set_mode(self) -> None:
            mode = termios.tcgetattr(self._fd)
            mode[3] &= ~(termios.ICANON | termios.ECHO)
            mode[6][termios.VMIN], mode[6][termios.VTIME] = 1, 0
            termios.tcsetattr(self._fd, termios.TCSADRAIN, mode)

        def _restore_mode(self) -> None:
            # In the background, this would stop the process before the terminal is restored.
            old = signal.signal(signal.SIGTTOU, signal.SIG_IGN)
            try:
                termios.tcsetattr(self._fd, termios.TCSANOW, self._found)
            except termios.error:
                pass  # the terminal is closed
            finally:
                signal.signal(signal.SIGTTOU, old)

        def _stop(self, number: int, _: FrameType | None) -> None:
            self._restore_mode()
            signal.signal(number, signal.SIG_DFL)
            os.kill(os.getpid(), number)
            signal.signal(number, self._stop)
            self._set_mode()

    def _exit_on_signal(number: int, _: FrameType | None) -> None:
        raise SystemExit(128 + number)

else:
    import msvcrt
    import time

    WINDOWS_ARROWS = {"H": "up", "P": "down", "M": "right", "K": "left"}
    POLL_S = 0.01

    class Keyboard:
        """Key presses at the console, which needs no mode."""

        def __enter__(self) -> Self:
            if not sys.stdin.isatty():
                raise NoTerminalError
            return self

        def __exit__(
            self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
        ) -> None:
            pass

        def read(self, timeout_s: float) -> list[str]:
            """Wait for keys and return all that were pressed; empty after the timeout."""
            end = time.monotonic() + timeout_s
            while not msvcrt.kbhit() and time.monotonic() < end:
                time.sleep(POLL_S)
            keys: list[str] = []
            while msvcrt.kbhit():
                letter = msvcrt.getwch()
                key = WINDOWS_ARROWS.get(msvcrt.getwch(), "") if letter in "\x00\xe0" else letter
                if key and keys[-1:] != [key]:
                    keys.append(key)
            return keys
