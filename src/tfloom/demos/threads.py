"""The demonstration's programs on threads of this process, for machines without DDS, over the wire `tfloom_local`.

Each runs by the same `main` as in a process, with its own command line, context and output.
"""

from __future__ import annotations

import contextlib
import io
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from importlib import import_module
from typing import TextIO

from tfloom.common.terminal import report
from tfloom.demos.processes import environment_set
from tfloom.demos.program_group import LOG_LINES, StartProgram
from tfloom.demos.show import PROGRAMS
from tfloom.node.context.context import Context
from tfloom.node.context.utilities import own_defaults

WINDOWLESS_PROGRAMS = PROGRAMS | {"turtlesim": [*PROGRAMS["turtlesim"], "--headless"]}
"""The programs, turtlesim's without its window, because only the main thread may open one."""

POLL_S = 0.05
"""Time after which the request to end is repeated [s]."""


@contextlib.contextmanager
def thread_starter() -> Iterator[StartProgram]:
    """Yield a function that starts a program on a thread; for the block, this process uses the wire `tfloom_local`.

    The output of the programs' threads is added to their logs; other output is unchanged.
    """
    with (
        environment_set({"RMW_IMPLEMENTATION": "tfloom_local", "ROS_DOMAIN_ID": "0"}),
        contextlib.redirect_stdout(_Output(sys.stdout)),
        contextlib.redirect_stderr(_Output(sys.stderr)),
    ):
        yield ThreadProgram


class ThreadProgram:
    """A program on a daemon thread; see `program_group.Program`.

    Args:
        command: `module:function` and arguments.
        on_line: Called with each printed line, on the program's thread; `log` keeps the last lines, too.
    """

    def __init__(self, command: list[str], on_line: Callable[[str], object] | None = None) -> None:
        self.log: deque[str] = deque(maxlen=LOG_LINES)
        self._on_line = on_line
        self._rest = ""
        self._context = Context()
        self._code = 0
        target, *args = command
        module, _, function = target.partition(":")
        # Imported here, one after the other, because threads that import modules of one ring could deadlock.
        main = getattr(import_module(module), function)
        self._thread = threading.Thread(target=self._run, args=(main, args), name=module, daemon=True)
        self._thread.start()

    def _run(self, main: Callable[[list[str]], int | None], args: list[str]) -> None:
        _printing.set(self)
        try:
            with own_defaults(self._context):
                self._code = int(main(args) or 0)
        except SystemExit as end:
            self._code = _exit_code(end)
        except BaseException:  # noqa: BLE001  # as the interpreter does with a process's main
            traceback.print_exc()
            self._code = 1
        finally:
            self._context.destroy()
            if self._rest:
                self.take("\n")

    def take(self, text: str) -> None:
        """Add a part of the program's output, and log each complete line; on the program's thread."""
        *lines, self._rest = (self._rest + text).split("\n")
        for line in lines:
            self.log.append(line)
            if self._on_line is not None:
                self._on_line(line)

    def exit_code(self) -> int | None:
        """Return its exit code; None while it runs."""
        return None if self._thread.is_alive() else self._code

    def request_end(self) -> None:
        """Shut its context down, as Ctrl-C does; without effect before the context is initialised."""
        self._context.interrupt()

    def end(self, grace_s: float) -> None:
        """Wait for its end, `grace_s` at most, because a thread can't be killed; it ends with this process."""
        until = time.monotonic() + grace_s
        while self._thread.is_alive() and (left := until - time.monotonic()) > 0.0:
            self.request_end()
            self._thread.join(min(left, POLL_S))


def _exit_code(end: SystemExit) -> int:
    """Return the interpreter's exit code for a SystemExit, and print its text if it has one."""
    if isinstance(end.code, str):
        report(end.code)
        return 1
    return end.code or 0


_printing: ContextVar[ThreadProgram | None] = ContextVar("printing", default=None)
"""The program that runs on the current thread."""


class _Output(io.TextIOBase):
    """Replacement of a standard stream: passes the output of programs to them, and all other output to the stream.

    Args:
        stream: The stream; None if it is closed.
    """

    def __init__(self, stream: TextIO | None) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        program = _printing.get()
        if program is not None:
            program.take(text)
        elif self._stream is not None:
            self._stream.write(text)
        return len(text)

    def flush(self) -> None:
        # Called on collection, too, when the stream may be closed already.
        if _printing.get() is None and self._stream is not None and not self._stream.closed:
            self._stream.flush()

    def isatty(self) -> bool:
        return _printing.get() is None and self._stream is not None and self._stream.isatty()
