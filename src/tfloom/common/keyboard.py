"""Single key presses from a terminal, whose mode is restored at any end of the program, and while it is stopped."""

from __future__ import annotations

import codecs
import os
import re
import signal
import sys
from collections.abc import Callable, Iterable
from types import FrameType, TracebackType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing_extensions import Self

NAMES = {
    "\x1b": "escape",
    "\r": "enter",
    "\n": "enter",
    "\x7f": "backspace",
    "\b": "backspace",
    "\x15": "clear",
}
"""Of control characters. `clear` is Ctrl-U."""
FINALS = {"A": "up", "B": "down", "C": "right", "D": "left", "H": "home", "F": "end"}
"""Of the last letter of a key's sequence."""
NUMBERS = {"1": "home", "7": "home", "4": "end", "8": "end", "5": "page up", "6": "page down"}
"""Of the first number of a sequence that ends in `~`."""
# A key's sequence as terminals send it: plain, in application mode, with a modifier key held; or the beginning of one.
_KEY = re.compile(
    r"\x1b(?:\[(?P<number>\d*)[\d;?]*|O)(?P<final>[@-~])|\x1b[O[][\d;?]*|(?P<letter>.)", re.DOTALL
)
_UNFINISHED = re.compile(r"\x1b(?:[O[][\d;?]*)?\Z")
ESCAPE_WAIT_S = 0.05
"""The longest wait for the rest of a key's sequence."""


class NoTerminalError(Exception):
    """The input is not a terminal, so single keys can't be read from it."""


def decode_keys(text: str) -> list[str]:
    """Return the keys in a terminal's input: letters, and names as `up`, `page down`, `home`, `enter`, `escape`.

    Sequences of other keys are ignored.
    """
    keys = []
    for match in _KEY.finditer(text):
        if letter := match["letter"]:
            keys.append(NAMES.get(letter, letter))
        elif key := NUMBERS.get(match["number"]) if match["final"] == "~" else FINALS.get(match["final"]):
            keys.append(key)
    return keys


def without_repetitions(keys: Iterable[str]) -> list[str]:
    """Return keys, each once for as long as it was held down.

    A terminal repeats a key that is held down, and repetitions that have accumulated must not be executed late.
    """
    distinct_keys: list[str] = []
    for key in keys:
        if distinct_keys[-1:] != [key]:
            distinct_keys.append(key)
    return distinct_keys


def _nothing() -> None:
    """Do nothing."""


class _Terminal:
    """The terminal of a `Keyboard`.

    Args:
        fd: File descriptor of the terminal.
        on_enter: Called when the mode is set: at the beginning, and after a stop.
        on_leave: Called when the mode is restored: before a stop, and at the end.
    """

    def __init__(
        self,
        fd: int = 0,
        on_enter: Callable[[], object] = _nothing,
        on_leave: Callable[[], object] = _nothing,
    ) -> None:
        self._fd = fd
        self._on_enter = on_enter
        self._on_leave = on_leave


if sys.platform != "win32":
    import select
    import termios

    class Keyboard(_Terminal):
        """Key presses on a terminal; a context manager that sets and restores its mode.

        Ctrl-C remains a signal. Hang-up and quit end the program by SystemExit; a stop (Ctrl-Z) restores the
        mode until the program continues. To be entered in the main thread. The arguments are those of `_Terminal`.
        """

        def __enter__(self) -> Self:
            if not os.isatty(self._fd):
                raise NoTerminalError
            self._former_settings = termios.tcgetattr(self._fd)
            self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
            self._handlers: dict[int, Callable[[int, FrameType | None], object] | int | None] = {}
            for number, handler in {
                signal.SIGHUP: _exit_on_signal,
                signal.SIGQUIT: _exit_on_signal,
                signal.SIGTSTP: self._stop,
            }.items():
                self._handlers[number] = signal.signal(number, handler)
            try:
                self._enter()
            except BaseException:  # a signal's too
                self.__exit__(None, None, None)
                raise
            return self

        def __exit__(
            self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
        ) -> None:
            self._leave()
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
            return self._decoder.decode(data)

        def _enter(self) -> None:
            mode = termios.tcgetattr(self._fd)
            mode[3] &= ~(termios.ICANON | termios.ECHO)
            mode[6][termios.VMIN], mode[6][termios.VTIME] = 1, 0
            termios.tcsetattr(self._fd, termios.TCSADRAIN, mode)
            self._on_enter()

        def _leave(self) -> None:
            # In the background, this would stop the process before the terminal is restored.
            old = signal.signal(signal.SIGTTOU, signal.SIG_IGN)
            try:
                termios.tcsetattr(self._fd, termios.TCSANOW, self._former_settings)
                self._on_leave()
            except (termios.error, OSError):
                pass  # the terminal is closed
            finally:
                signal.signal(signal.SIGTTOU, old)

        def _stop(self, number: int, _: FrameType | None) -> None:
            self._leave()
            # By its own signal, which stops no program that nothing could continue: one without a shell.
            signal.signal(number, signal.SIG_DFL)
            os.kill(os.getpid(), number)
            signal.signal(number, self._stop)
            self._enter()

    def _exit_on_signal(number: int, _: FrameType | None) -> None:
        raise SystemExit(128 + number)

else:
    import msvcrt
    import time

    WINDOWS_KEYS = {
        "H": "up",
        "P": "down",
        "M": "right",
        "K": "left",
        "I": "page up",
        "Q": "page down",
        "G": "home",
        "O": "end",
    }
    """By the letter after the prefix of a key without a character."""
    POLL_S = 0.01

    class Keyboard(_Terminal):
        """Key presses at the console, which needs no mode; the arguments are those of `_Terminal`."""

        def __enter__(self) -> Self:
            if not os.isatty(self._fd):
                raise NoTerminalError
            self._on_enter()
            return self

        def __exit__(
            self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
        ) -> None:
            self._on_leave()

        def read(self, timeout_s: float) -> list[str]:
            """Wait for keys and return all that were pressed; empty after the timeout."""
            end = time.monotonic() + timeout_s
            while not msvcrt.kbhit() and time.monotonic() < end:
                time.sleep(POLL_S)
            keys: list[str] = []
            while msvcrt.kbhit():
                letter = msvcrt.getwch()
                if letter not in "\x00\xe0":
                    keys.append(NAMES.get(letter, letter))
                elif key := WINDOWS_KEYS.get(msvcrt.getwch()):
                    keys.append(key)
            return keys
