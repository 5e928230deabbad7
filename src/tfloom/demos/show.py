"""The demonstration: a turtle that draws, one that follows it, a sensor, and their frames in tf2.

Each is a separate process and they communicate over DDS, as a user's would; all of them end with this one.
"""

from __future__ import annotations

import contextlib
import math
import os
import queue
import random
import signal
import socket
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

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
"""The programs that run all the time: `module:function` and arguments."""
ECHO = ["tfloom.tf2_tools.echo:main", "world", "laser"]
VIEW_FRAMES = ["tfloom.tf2_tools.view_frames:main", "-o", "frames", "-t", "3"]
PATIENCE_S = 40.0
"""How long it may take until the tree is drawn [s]."""
END_GRACE_S = 3.0
LOG_LINES = 40
DOMAINS = range(1, 101)
"""Domains whose ports, by DDS's formula, are outside of the system's ephemeral range."""


class ShowError(Exception):
    """The demonstration can't continue; the text has the reason."""


@contextlib.contextmanager
def own_domain() -> Iterator[int]:
    """Yield a DDS domain that no other demonstration on this machine uses, by a TCP port as a lock."""
    for domain in random.sample(DOMAINS, len(DOMAINS)):
        lock = socket.socket()
        try:
            lock.bind(("127.0.0.1", 7400 + 250 * domain))
        except OSError:
            lock.close()
            continue
        with lock:
            yield domain
        return
    raise ShowError("all DDS domains from 1 to 100 are in use")


class Program:
    """A child process with captured output.

    Args:
        command: `module:function` and arguments.
        environment: Its environment variables.
        folder: Its working directory.
        on_line: Called with each line that it prints, on a separate thread; `log` keeps the last of them, too.
    """

    def __init__(
        self,
        command: list[str],
        environment: Mapping[str, str],
        folder: Path,
        on_line: Callable[[str], object] | None = None,
    ) -> None:
        self.log: deque[str] = deque(maxlen=LOG_LINES)
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tfloom.demos.child", *command],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            cwd=folder,
            env=environment,
            start_new_session=True,  # because a Ctrl-C is for this process, which then ends the others
        )
        self._reader = threading.Thread(target=self._read, args=(on_line,), daemon=True)
        self._reader.start()

    def _read(self, on_line: Callable[[str], object] | None) -> None:
        for line in self._process.stdout or ():
            self.log.append(line.rstrip("\n"))
            if on_line is not None:
                on_line(self.log[-1])

    def exit_code(self) -> int | None:
        """Return its exit code, None while it runs."""
        code = self._process.poll()
        if code is not None:
            self._reader.join(END_GRACE_S)
        return code

    def ask_to_end(self) -> None:
        """Send it SIGINT, as Ctrl-C does."""
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT if os.name == "posix" else signal.SIGTERM)

    def end(self, grace_s: float) -> None:
        """Wait for its end, and kill it if that takes too long."""
        try:
            self._process.wait(grace_s)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join(END_GRACE_S)
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()


class Show:
    """Runs the programs and prints tf2_echo's output; a context that leaves no process behind.

    Args:
        domain_id: DDS domain of all programs; they use the loopback interface alone.
        folder: The folder of the drawing.
    """

    def __init__(self, domain_id: int, folder: Path) -> None:
        self._folder = folder
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._programs: dict[str, Program] = {}
        self._has_drawn = False
        self._environment = os.environ | {
            "ROS_DOMAIN_ID": str(domain_id),
            "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
            "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
        }
        self._environment.pop("CYCLONEDDS_URI", None)

    def __enter__(self) -> Self:
        try:
            for name, command in PROGRAMS.items():
                self._start(name, command)
            self._start("tf2_echo", ECHO, self._lines.put)
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._end()

    def _start(self, name: str, command: list[str], on_line: Callable[[str], object] | None = None) -> None:
        self._programs[name] = Program(command, self._environment, self._folder, on_line)

    def _end(self) -> None:
        for program in self._programs.values():
            program.ask_to_end()
        end = time.monotonic() + END_GRACE_S
        for program in self._programs.values():
            program.end(max(0.0, end - time.monotonic()))
        if (self._folder / PICTURE).exists():
            print(f"What the turtles drew is in {self._folder / PICTURE}")

    def run(self, seconds: float | None) -> None:
        """Print tf2_echo's output, and draw the tree as soon as it is complete.

        Args:
            seconds: How long, but at least until the tree is drawn; None: until interrupted.

        Raises:
            ShowError: a program ended by itself, or there was no tree to draw for too long.
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
        """Return whether the second turtle is there, too."""
        return any("Successfully spawned" in line for line in list(self._programs["listener"].log))

    def _check(self) -> None:
        """Print the drawing's path once it exists; raise for a program that failed or ended too early."""
        for name, program in self._programs.items():
            code = program.exit_code()
            if code is None or (name == "view_frames" and self._has_drawn):
                continue
            if code or name != "view_frames":
                log = "\n".join(program.log)
                raise ShowError(f"{name} ended by itself with exit code {code}\n{log}".rstrip())
            self._has_drawn = True
            print(f"The tree of frames is drawn in {self._folder / 'frames.pdf'}")
