"""Programs that a demonstration starts, shows and ends together.

The caller selects how they run: as processes over DDS (`processes.py`), as a user would run them, or on threads of this
process (`threads.py`), if there is no DDS. All of them end with this process.
"""

from __future__ import annotations

import contextlib
import queue
import time
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Protocol

from tfloom.common.terminal import has_browser

if TYPE_CHECKING:
    from typing_extensions import Self

ADDRESS = "Open "
"""What precedes the page's address in the output of `view`."""
TELLS_ADDRESS = "See it in a browser: "
END_GRACE_S = 3.0
POLL_S = 0.05
LOG_LINES = 40
"""Number of a program's last lines that are kept."""


class ShowError(Exception):
    """The demonstration can't continue; the text has the reason."""


class Program(Protocol):
    """A program that has been started."""

    @property
    def log(self) -> Iterable[str]:
        """The last lines that it printed."""

    def exit_code(self) -> int | None:
        """Return its exit code; None while it runs."""

    def request_end(self) -> None:
        """Request its end, as Ctrl-C does."""

    def end(self, grace_s: float) -> None:
        """Wait for its end, `grace_s` at most, and release its resources."""


StartProgram = Callable[[list[str], Callable[[str], object] | None], Program]
"""A function that starts `[module:function, *arguments]`, or a file of Python in place of the former, in the current
folder; its second argument is called with each printed line, on a thread of the program's own."""


def unexpected_end(name: str, program: Program) -> ShowError:
    """Return the error of a program that has ended, with the last lines that it printed."""
    log = "\n".join(program.log)
    return ShowError(f"{name} ended unexpectedly with exit code {program.exit_code()}\n{log}".rstrip())


class ProgramGroup:
    """Runs programs, and collects what is to be printed; a context manager that ends all programs on exit.

    Args:
        start: Starts a program.
        programs: The programs by their names: `module:function`, or a file, and arguments.
        shown: The programs whose lines are printed.
        opens_page: Whether to open the page of the program `view` in a browser, if there is one. Its address is then
            the last line until the end.
    """

    def __init__(
        self,
        start: StartProgram,
        programs: Mapping[str, list[str]],
        shown: Iterable[str] = (),
        *,
        opens_page: bool = False,
    ) -> None:
        self._opens_page = opens_page
        self._start_program = start
        self._commands = programs
        self._shown = frozenset(shown)
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._programs: dict[str, Program] = {}
        self._address = ""
        """Where the page is; empty: not yet."""
        self._awaits_page = "view" in programs
        """Whether the page's address is still to be printed: a demonstration doesn't end before."""

    def __enter__(self) -> Self:
        try:
            for name, command in self._commands.items():
                self._start(name, command)
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def _start(self, name: str, command: list[str]) -> None:
        on_line: Callable[[str], object] | None = None
        if name == "view":
            on_line = self._take_address
        elif name in self._shown:
            on_line = self._lines.put
        self._programs[name] = self._start_program(command, on_line)

    def _take_address(self, line: str) -> None:
        """Open the page when it is there; on the thread of its program."""
        if not line.startswith(ADDRESS):
            return
        self._address = line.removeprefix(ADDRESS)
        if self._opens_page and has_browser():
            import webbrowser

            webbrowser.open(self._address)

    def _print_line(self, timeout_s: float = 0.1) -> str:
        """Print the next line of the shown programs, and return it; an empty text if there is none in time.

        Behind the address of a page that was asked for nothing is printed, so that its user finds it.
        """
        if self._awaits_page and self._address and (self._has_told() or not self._opens_page):
            self._awaits_page = False
            print(f"{TELLS_ADDRESS}{self._address}\n", end="")
        with contextlib.suppress(queue.Empty):
            line = self._lines.get(timeout=timeout_s)
            self._note(line)
            if self._awaits_page or not self._opens_page:
                print(f"{line}\n", end="")  # in one piece, because Ctrl-C may come after any write
            return line
        return ""

    def _has_told(self) -> bool:
        """Return whether what comes before the page's address was printed."""
        return True

    def _note(self, line: str) -> None:
        """Take note of a line of a shown program before it is printed, because Ctrl-C may come right after."""

    def output_of(self, name: str, patience_s: float) -> str:
        """Wait for the end of a program, and return the last lines that it printed.

        Raises:
            ShowError: it has failed, or not ended in time.
        """
        program = self._programs[name]
        until = time.monotonic() + patience_s
        while (code := program.exit_code()) is None:
            if time.monotonic() > until:
                raise ShowError(f"{name} has not ended in {patience_s:.0f} s")
            time.sleep(POLL_S)
        if code:
            raise unexpected_end(name, program)
        return "\n".join(program.log)

    def _end(self) -> None:
        for program in self._programs.values():
            program.request_end()
        end = time.monotonic() + END_GRACE_S
        for program in self._programs.values():
            program.end(max(0.0, end - time.monotonic()))
