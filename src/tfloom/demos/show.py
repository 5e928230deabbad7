"""The demonstration: a turtle that draws, one that follows it, a sensor, and what tf2 makes of them.

How its programs run is the caller's choice: as processes over DDS (`processes.py`), as a user's would, or on threads
of this process (`threads.py`), where there is no DDS. All of them end with this one.
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
"""What runs all the time: `module:function` and arguments. Turtlesim opens its window where there is a display."""
ECHO = ["tfloom.tf2_tools.echo:main", "world", "laser"]
VIEW_FRAMES = ["tfloom.tf2_tools.view_frames:main", "-o", "frames", "-t", "3"]
PATIENCE_S = 40.0
"""How long it may take until the tree is drawn [s]."""
END_GRACE_S = 3.0
LOG_LINES = 40
"""How many of a program's last lines are kept."""


class ShowError(Exception):
    """The demonstration can't go on; its text says why."""


class Program(Protocol):
    """A program under our care: from its start on it runs by itself."""

    @property
    def log(self) -> Iterable[str]:
        """The last lines that it printed."""

    def exit_code(self) -> int | None:
        """Return its exit code, None while it runs."""

    def ask_to_end(self) -> None:
        """End it as Ctrl-C would."""

    def end(self, grace_s: float) -> None:
        """Wait for its end, `grace_s` at most, and leave nothing open."""


StartProgram = Callable[[list[str], Callable[[str], object] | None], Program]
"""Starts `[module:function, *arguments]` in the current folder; the second argument takes each line that it prints, on
a thread of the program's own."""


class Show:
    """Runs the programs and prints what tf2_echo sees; a context that leaves none of them running.

    Drawings go to the current folder.

    Args:
        start: Starts a program.
        programs: What runs all the time beside tf2_echo, as `PROGRAMS`.
    """

    def __init__(self, start: StartProgram, programs: Mapping[str, list[str]] = PROGRAMS) -> None:
        self._start_program = start
        self._commands = programs
        self._folder = Path.cwd()
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._programs: dict[str, Program] = {}
        self._has_drawn = False

    def __enter__(self) -> Self:
        try:
            for name, command in self._commands.items():
                self._start(name, command)
            self._start("tf2_echo", ECHO, self._lines.put)
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def _start(self, name: str, command: list[str], on_line: Callable[[str], object] | None = None) -> None:
        self._programs[name] = self._start_program(command, on_line)

    def _end(self) -> None:
        for program in self._programs.values():
            program.ask_to_end()
        end = time.monotonic() + END_GRACE_S
        for program in self._programs.values():
            program.end(max(0.0, end - time.monotonic()))
        if (self._folder / PICTURE).exists():
            print(f"What the turtles drew is in {self._folder / PICTURE}")

    def run(self, seconds: float | None) -> None:
        """Print what tf2_echo sees, and draw the tree as soon as it is complete.

        Args:
            seconds: How long, but until the tree is drawn at least; None goes on until interrupted.

        Raises:
            ShowError: a program ended by itself, or there was nothing to draw for too long.
        """
        started = time.monotonic()
        end = math.inf if seconds is None else started + seconds
        while not self._has_drawn or time.monotonic() < end:
            self._check()
            with contextlib.suppress(queue.Empty):
                line = self._lines.get(timeout=0.1)
                print(line)
                if line.startswith("At time") and self._is_complete() and "view_frames" not in self._programs:
                    self._start("view_frames", VIEW_FRAMES)
            if not self._has_drawn and time.monotonic() > started + PATIENCE_S:
                raise ShowError(f"the turtle's frames could not be drawn in {PATIENCE_S:.0f} s")

    def _is_complete(self) -> bool:
        """Whether the second turtle is there, too."""
        return any("Successfully spawned" in line for line in list(self._programs["listener"].log))

    def _check(self) -> None:
        """Tell of the drawing once it is there; raise for a program that failed or shouldn't have ended."""
        for name, program in self._programs.items():
            code = program.exit_code()
            if code is None or (name == "view_frames" and self._has_drawn):
                continue
            if code or name != "view_frames":
                log = "\n".join(program.log)
                raise ShowError(f"{name} ended by itself with exit code {code}\n{log}".rstrip())
            self._has_drawn = True
            print(f"The tree of frames is drawn in {self._folder / 'frames.pdf'}")
