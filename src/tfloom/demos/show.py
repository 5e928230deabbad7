"""The demonstration: a turtle that draws, one that follows it, a sensor, and their frames in tf2."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from pathlib import Path

from tfloom.demos.program_group import ProgramGroup, ShowError, StartProgram, unexpected_end

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
ECHO = {"tf2_echo": ["tfloom.tf2_tools.echo:main", "world", "laser"]}
VIEW_FRAMES = ["tfloom.tf2_tools.view_frames:main", "-o", "frames", "-t", "3"]
PATIENCE_S = 40.0
"""The longest time until the tree is drawn [s]."""


class Show(ProgramGroup):
    """Runs the programs and prints the output of tf2_echo. Drawings go to the current folder.

    Args:
        start: Starts a program.
        programs: The programs besides tf2_echo, as `PROGRAMS`.
        opens_page: Whether to open the page of the program `view` in a browser.
    """

    def __init__(
        self, start: StartProgram, programs: Mapping[str, list[str]] = PROGRAMS, *, opens_page: bool = False
    ) -> None:
        super().__init__(start, {**programs, **ECHO}, ECHO, opens_page=opens_page)
        self._folder = Path.cwd()
        self._has_drawn = False

    def _end(self) -> None:
        super()._end()
        if (self._folder / PICTURE).exists():
            print(f"The picture of the turtles is in {self._folder / PICTURE}")

    def run(self, seconds: float | None) -> None:
        """Print the output of tf2_echo, and draw the tree as soon as it is complete.

        Args:
            seconds: Duration, extended until the tree is drawn and the page is there; None: until interrupted.

        Raises:
            ShowError: a program ended unexpectedly, or the tree or the page was not there in time.
        """
        started = time.monotonic()
        end = math.inf if seconds is None else started + seconds
        while not self._has_drawn or self._awaits_page or time.monotonic() < end:
            self._check()
            line = self._print_line()
            if line.startswith("At time") and self._is_complete() and "view_frames" not in self._programs:
                self._start("view_frames", VIEW_FRAMES)
            if time.monotonic() > started + PATIENCE_S:
                if not self._has_drawn:
                    raise ShowError(f"the turtle's frames could not be drawn in {PATIENCE_S:.0f} s")
                if self._awaits_page:
                    raise ShowError(f"the page was not there in {PATIENCE_S:.0f} s")

    def _has_told(self) -> bool:
        return self._has_drawn

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
                raise unexpected_end(name, program)
            self._has_drawn = True
            print(f"The tree of frames is drawn in {self._folder / 'frames.pdf'}")
            if (self._folder / PICTURE).exists():
                print(f"The turtles, drawn anew each second, are in {self._folder / PICTURE}")
