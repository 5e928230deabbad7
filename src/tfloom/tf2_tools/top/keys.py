"""Keys from a terminal, one by one: by termios, and by msvcrt at the console of Windows, which has no termios."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

if sys.platform == "win32":
    import msvcrt

    WINDOWS_KEYS = {
        "H": "\x1b[A",
        "P": "\x1b[B",
        "I": "\x1b[5~",
        "Q": "\x1b[6~",
        "G": "\x1b[H",
        "O": "\x1b[F",
    }
    """The letter after the prefix of a key without a character, and the sequence that terminals send for it."""
    OTHER = "\x1b[~"
    POLL_S = 0.01

    def wait(_: int, timeout_s: float) -> bool:
        """Wait for a key, and return whether there is one."""
        end = time.monotonic() + timeout_s
        while not msvcrt.kbhit():
            if time.monotonic() >= end:
                return False
            time.sleep(POLL_S)
        return True

    def read(_: int) -> bytes:
        """Return the keys that were pressed, in the sequences of terminals; `wait` has found one."""
        letters = []
        while msvcrt.kbhit():
            letter = msvcrt.getwch()
            letters.append(WINDOWS_KEYS.get(msvcrt.getwch(), OTHER) if letter in "\x00\xe0" else letter)
        return "".join(letters).encode()

    def write(_: int, text: str) -> None:
        """Write to the console, which takes UTF-16 by Python's own stream alone."""
        stream = sys.__stdout__
        if stream is not None:
            stream.write(text)
            stream.flush()

    @contextmanager
    def single(_: int, enter: Callable[[], object], leave: Callable[[], object]) -> Iterator[None]:
        """Call `enter`, and `leave` at the end of the block. The console needs no mode for single keys.

        An empty command has the console obey escape sequences from then on.
        """
        os.system("")  # noqa: S605
        try:
            enter()
            yield
        finally:
            leave()

else:
    import select
    import termios
    import tty

    def wait(keys: int, timeout_s: float) -> bool:
        """Wait for a key, and return whether there is one; or the end of the input."""
        return bool(select.select([keys], [], [], timeout_s)[0])

    def read(keys: int) -> bytes:
        """Return what was typed; empty at the end of the input."""
        try:
            return os.read(keys, 1024)
        except OSError:  # EIO: the other end of the terminal is closed
            return b""

    def write(output: int, text: str) -> None:
        """Write to the terminal: not by `sys.stdout`, which shows control characters."""
        data = memoryview(text.encode("utf-8", "replace"))
        while data:
            data = data[os.write(output, data) :]

    @contextmanager
    def single(keys: int, enter: Callable[[], object], leave: Callable[[], object]) -> Iterator[None]:
        """Have the terminal send single keys for the block; call `enter` at its beginning, and `leave` at its end.

        Both are also called around a stop by Ctrl-Z, during which the terminal has its former mode.
        """
        before = termios.tcgetattr(keys)

        def begin() -> None:
            tty.setcbreak(keys)
            enter()

        def end() -> None:
            termios.tcsetattr(keys, termios.TCSADRAIN, before)
            leave()

        def suspend(_: int, __: FrameType | None) -> None:
            end()
            os.kill(os.getpid(), signal.SIGSTOP)
            begin()

        former = signal.signal(signal.SIGTSTP, suspend)
        try:
            begin()
            yield
        finally:
            signal.signal(signal.SIGTSTP, former)
            end()
