"""The demonstration: a turtle that draws, one that follows it, a sensor, and their frames in tf2.

The caller selects how its programs run: as processes over DDS (`processes.py`), as a user would run them, or on
threads of this process (`threads.py`), if there is no DDS. All of them end with this process.
"""

from __future__ import annotations

import contextlib
import math
import queue
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from typing_extensions import Self

PICTURE = "turtles.png"
DEMOS = "tfloom.demos.turtle_tf2_py"
PROGRAMS: dict[str, list[str]] = {
    "turtlesim": ["tfloom.turtlesim.node:main", "--record", PICTURE],
    "broadcaster1": [
        f"{DEMOS}.turtle_tf2_broadcaster:main",
        *("--ros-args", "-r", "__node:=broadcaster1", "-p", "turtlename:=turtle1"),
    ],
    "broadcaster2": [
        f"{DEMOS}.turtle_tf2_broadcaster:main",
        *("--ros-args", "-r", "__node:=broadcaster2", "-p", "turtlename:=turtle2"),
    ],
    "listener": [
        f"{DEMOS}.turtle_tf2_listener:main",
        *("--ros-args", "-r", "__node:=listener", "-p", "target_frame:=turtle1"),
    ],
    "laser": [
        "tfloom.tf2_tools.static_publisher:main",
        *("--x", "0.3", "--z", "0.1", "--frame-id", "turtle1", "--child-frame-id", "laser"),
    ],
    "driver": [f"{DEMOS}.curve_driver:main"],
}
"""The programs: `module:function` and arguments. Turtlesim opens its window if there is a display."""
TURTLES = ("/turtle1/pose", "/turtle2/pose")
VIEW = {
    "view": [
        "tfloom.cli.main:main",
        *("view", "--no-open", "--fixed-frame", "world"),
        *(word for topic in TURTLES for word in ("--display", topic)),
    ]
}
"""The page of the demonstration, a program for those that have the extra `view`."""
ADDRESS = "Open "
"""What precedes the page's address in the output of `view`."""
ECHO = ["tfloom.tf2_tools.echo:main", "world", "laser"]
VIEW_FRAMES = ["tfloom.tf2_tools.view_frames:main", "-o", "frames", "-t", "3"]
PATIENCE_S = 40.0
"""The longest time until the tree is drawn [s]."""
END_GRACE_S = 3.0
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
"""A function that starts `[module:function, *arguments]` in the current folder; its second argument is called with
each printed line, on a thread of the program's own."""


class Show:
    """Runs the programs and prints the output of tf2_echo; a context manager that ends all programs on exit.

    Drawings go to the current folder.

    Args:
        start: Starts a program.
        programs: The programs besides tf2_echo, as `PROGRAMS`.
        opens_page: Whether to open the page of the program `view` in a browser.
    """

    def __init__(
        self, start: StartProgram, programs: Mapping[str, list[str]] = PROGRAMS, *, opens_page: bool = False
    ) -> None:
        self._opens_page = opens_page
        self._start_program = start
        self._commands = programs
        self._folder = Path.cwd()
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._programs: dict[str, Program] = {}
        self._has_drawn = False

    def __enter__(self) -> Self:
        try:
            for name, command in self._commands.items():
                self._start(name, command, self._show_address if name in VIEW else None)
            self._start("tf2_echo", ECHO, self._lines.put)
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def _start(self, name: str, command: list[str], on_line: Callable[[str], object] | None = None) -> None:
        self._programs[name] = self._start_program(command, on_line)

    def _show_address(self, line: str) -> None:
        """Print the address of the page when it is there; on the thread of its program."""
        if not line.startswith(ADDRESS):
            return
        address = line.removeprefix(ADDRESS)
        self._lines.put(f"See it in a browser: {address}")
        if self._opens_page:
            import webbrowser

            webbrowser.open(address)

    def _end(self) -> None:
        for program in self._programs.values():
            program.request_end()
        end = time.monotonic() + END_GRACE_S
        for program in self._programs.values():
            program.end(max(0.0, end - time.monotonic()))
        if (self._folder / PICTURE).exists():
            print(f"The picture of the turtles is in {self._folder / PICTURE}")

    def run(self, seconds: float | None) -> None:
        """Print the output of tf2_echo, and draw the tree as soon as it is complete.

        Args:
            seconds: Duration, extended until the tree is drawn; None: until interrupted.

        Raises:
            ShowError: a program ended unexpectedly, or the tree was not complete in time.
        """
        started = time.monotonic()
        end = math.inf if seconds is None else started + seconds
        while not self._has_drawn or time.monotonic() < end:
            self._check()
            with contextlib.suppress(queue.Empty):
                line = self._lines.get(timeout=0.1)
                print(f"{line}\n", end="")  # in one piece, because Ctrl-C may come after any write
                if line.startswith("At time") and self._is_complete() and "view_frames" not in self._programs:
                    self._start("view_frames", VIEW_FRAMES)
            if not self._has_drawn and time.monotonic() > started + PATIENCE_S:
                raise ShowError(f"the turtle's frames could not be drawn in {PATIENCE_S:.0f} s")

    def _is_complete(self) -> bool:
        """Return whether the second turtle is in the tree, too."""
        return any("Successfully spawned" in line for line in list(self._programs["listener"].log))

    def _check(self) -> None:
        """Print the drawings' paths when they are there; raise ShowError for a program that has ended unexpectedly."""
        for name, program in self._programs.items():
            code = program.exit_code()
            if code is None or (name == "view_frames" and self._has_drawn):
                continue
            if code or name != "view_frames":
                log = "\n".join(program.log)
                raise ShowError(f"{name} ended unexpectedly with exit code {code}\n{log}".rstrip())
            self._has_drawn = True
            print(f"The tree of frames is drawn in {self._folder / 'frames.pdf'}")
            if (self._folder / PICTURE).exists():
                print(f"The turtles, drawn anew each second, are in {self._folder / PICTURE}")
