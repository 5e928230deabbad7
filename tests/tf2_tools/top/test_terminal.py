"""`tf top` on a terminal: what is shown, keys, another size, and the terminal as it was, however it ends."""

from __future__ import annotations

import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import termios
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.cli.main import main
from tfloom.tf2_tools.top.terminal import LEAVE

PATIENCE_S = 20.0
ROBOT = """
import time
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.client_library import init
from tfloom.node.node import Node
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster

init()
node = Node("wheels")
moving, fixed = (TransformStamped(child_frame_id=name) for name in ("base", "laser"))
moving.header.frame_id, fixed.header.frame_id = "odom", "base"
moving.transform.rotation.w = fixed.transform.rotation.w = 1.0
fixed.transform.translation.z = 0.5
StaticTransformBroadcaster(node).sendTransform(fixed)
broadcaster = TransformBroadcaster(node)
print("running", flush=True)
while True:
    moving.header.stamp = node.get_clock().now().to_msg()
    broadcaster.sendTransform(moving)
    time.sleep(0.02)
"""


WITH_A_TERMINAL = """
import fcntl, os, sys, termios
fcntl.ioctl(0, termios.TIOCSCTTY, 0)
os.execv(sys.executable, [sys.executable, "-m", "tfloom", *sys.argv[1:]])
"""
"""Runs tfloom with standard input as its controlling terminal, whose Ctrl-C and Ctrl-Z it gets."""
WITH_A_SHELL = """
import fcntl, os, signal, sys, termios
fcntl.ioctl(0, termios.TIOCSCTTY, 0)
signal.signal(signal.SIGTTOU, signal.SIG_IGN)
program = os.fork()
if not program:
    os.setpgid(0, 0)
    os.tcsetpgrp(0, os.getpid())
    signal.signal(signal.SIGTTOU, signal.SIG_DFL)
    os.execv(sys.executable, [sys.executable, "-m", "tfloom", *sys.argv[1:]])
while os.WIFSTOPPED(status := os.waitpid(program, os.WUNTRACED)[1]):
    os.kill(os.getpid(), signal.SIGSTOP)
    os.tcsetpgrp(0, program)
    os.kill(program, signal.SIGCONT)
sys.exit(os.waitstatus_to_exitcode(status))
"""
"""The same as the child of a shell, because the kernel stops no program that has none; the shell stops with it."""


class Terminal:
    """A terminal that runs a program, and shows where each text is."""

    def __init__(
        self, *words: str, columns: int = 100, lines: int = 20, starter: str = WITH_A_TERMINAL
    ) -> None:
        self.ours, self._theirs = pty.openpty()
        self.resize(columns, lines)
        self.before = termios.tcgetattr(self._theirs)
        environment = os.environ | {"TERM": "xterm-256color"}
        environment.pop("NO_COLOR", None)
        self.process = subprocess.Popen(
            [sys.executable, "-c", starter, *words],
            stdin=self._theirs,
            stdout=self._theirs,
            stderr=self._theirs,
            env=environment,
            start_new_session=True,
        )
        self.raw = ""

    def resize(self, columns: int, lines: int) -> None:
        fcntl.ioctl(self._theirs, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))

    def attributes(self) -> list[object]:
        return termios.tcgetattr(self._theirs)

    def press(self, keys: str) -> None:
        os.write(self.ours, keys.encode())

    def read(self, timeout_s: float = 0.05) -> None:
        while select.select([self.ours], [], [], timeout_s)[0]:
            self.raw += os.read(self.ours, 65536).decode("utf-8", "replace")

    def screen(self) -> list[str]:
        """Return the lines that are shown now."""
        lines: dict[int, str] = {}
        start = max(self.raw.rfind("\x1b[2J"), 0)
        for match in re.finditer(r"\x1b\[(\d+);1H(.*?)(?=\x1b\[\d+;1H|\Z)", self.raw[start:], re.DOTALL):
            lines[int(match[1])] = re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", match[2])
        return [lines[number] for number in sorted(lines)]

    def wait_for(self, is_shown: Callable[[list[str]], bool]) -> list[str]:
        end_s = time.monotonic() + PATIENCE_S
        while time.monotonic() < end_s:
            self.read()
            if is_shown(lines := self.screen()):
                return lines
        pytest.fail("not shown:\n" + "\n".join(self.screen()) + repr(self.raw[-500:]))

    def wait(self) -> int:
        end_s = time.monotonic() + PATIENCE_S
        while self.process.poll() is None and time.monotonic() < end_s:
            self.read()
        self.read()
        return self.process.wait(timeout=1.0)

    def hang_up(self) -> None:
        os.close(self.ours)
        os.close(self._theirs)
        self.ours = self._theirs = -1

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        if self.ours >= 0:
            self.hang_up()


@pytest.fixture
def terminal() -> Iterator[Callable[..., Terminal]]:
    opened: list[Terminal] = []

    def start(*words: str, **options: Any) -> Terminal:
        opened.append(Terminal(*words, **options))
        return opened[-1]

    yield start
    for opened_terminal in opened:
        opened_terminal.close()


@pytest.fixture(scope="module")
def robot(module_domain_id: int, start_module_program: Callable[..., object]) -> int:
    start_module_program(sys.executable, "-c", ROBOT).wait_for("running")  # type: ignore[attr-defined]
    return module_domain_id


def row(lines: list[str], name: str) -> str:
    return next((line for line in lines if re.search(rf"\b{name}\b", line)), "")


def test_the_table_changes_with_keys_and_size_and_q_ends_it(
    robot: int, terminal: Callable[..., Terminal]
) -> None:
    shown = terminal("tf", "top", "--follow", "odom", "laser")
    lines = shown.wait_for(lambda lines: "z    +0.500" in "".join(lines) and "/wheels" in row(lines, "base"))
    assert len(lines) == 20
    assert lines[0].startswith(f"domain {robot}: 3 frames, 2 edges, 1 publisher")
    assert row(lines, "laser").split()[-2:] == ["static", "/wheels"]
    rate, age, delay = map(float, row(lines, "base").split()[-4:-1])
    assert 20.0 < rate <= 55.0
    assert 0.0 <= age < 1.0
    assert -1.0 < delay < 1000.0
    shown.wait_for(
        lambda lines: "z    +0.500" in "".join(lines) and row(lines, "base") != row(lines[:0], "base")
    )
    shown.press("/laser\r")
    lines = shown.wait_for(lambda lines: "filter 'laser': 1" in lines[0])
    assert row(lines, "base").startswith("laser (base)")
    shown.press("\x1b")
    shown.wait_for(lambda lines: "filter" not in lines[0] and "z    +0.500" not in "".join(lines))
    shown.resize(60, 10)
    lines = shown.wait_for(lambda lines: len(lines) == 10)
    assert {len(line) for line in lines} == {60}
    assert shown.attributes() != shown.before
    shown.press("q")
    assert shown.wait() == 0
    assert shown.raw.endswith(LEAVE)
    assert shown.attributes() == shown.before


@pytest.mark.parametrize(
    ("number", "code"),
    [(signal.SIGTERM, 143), (signal.SIGINT, 2), (signal.SIGQUIT, 131), (signal.SIGHUP, 129)],
)
def test_a_signal_gives_the_terminal_back(
    robot: int, terminal: Callable[..., Terminal], number: int, code: int
) -> None:
    shown = terminal("tf", "top")
    shown.wait_for(lambda lines: "/wheels" in "".join(lines))
    if number == signal.SIGINT:
        shown.press("\x03")
    else:
        shown.process.send_signal(number)
    assert shown.wait() == code
    assert shown.raw.endswith(LEAVE)
    assert shown.attributes() == shown.before


def test_suspending_gives_the_terminal_back_until_the_program_continues(
    robot: int, terminal: Callable[..., Terminal]
) -> None:
    shown = terminal("tf", "top", starter=WITH_A_SHELL)
    shown.wait_for(lambda lines: "/wheels" in "".join(lines))
    shown.press("\x1a")
    os.waitpid(shown.process.pid, os.WUNTRACED)
    shown.read()
    assert shown.raw.endswith(LEAVE)
    assert shown.attributes() == shown.before
    shown.raw = ""
    shown.process.send_signal(signal.SIGCONT)
    shown.wait_for(lambda lines: "/wheels" in "".join(lines))
    shown.press("q")
    assert shown.wait() == 0


def test_a_terminal_that_is_closed_ends_the_program(robot: int, terminal: Callable[..., Terminal]) -> None:
    shown = terminal("tf", "top")
    shown.wait_for(lambda lines: "/wheels" in "".join(lines))
    shown.press("/")
    shown.wait_for(lambda lines: any("filter" in line for line in lines[1:]))
    shown.hang_up()
    assert shown.process.wait(timeout=PATIENCE_S) in {0, 129}


def test_without_a_terminal_the_table_is_printed_once(robot: int, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tf", "top", "--follow", "odom", "laser"]) == 0
    output = capsys.readouterr().out
    lines = output.splitlines()
    assert [line.split()[0] for line in lines[1:3]] == ["FRAME", "odom"]
    assert "└ base" in lines[3]
    assert "translation [m]    x    +0.000  y    +0.000  z    +0.500" in lines[-2]
    assert "\x1b" not in output
