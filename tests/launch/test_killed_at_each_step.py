"""Each process of a launch is killed at each step of its life: what is left is what the launch promises.

The slow tests kill each process at each step, in a launch with nodes on DDS, too.
"""

from __future__ import annotations

import os
import signal
import sys
import uuid
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import psutil
import pytest
from tests.conftest import Program

pytestmark = pytest.mark.skipif(os.name == "nt", reason="SIGKILL and a POSIX shell are needed")

MARK = "TFLOOM_TEST_MARK"
SENSOR = Path(__file__).parents[2] / "examples" / "lifecycle" / "sensor.py"
END_S = 40.0
"""Time until the guardian, or the launch, has sent all signals, on a busy machine [s]."""
TIMEOUTS = "sigterm_timeout='1.5', sigkill_timeout='1.5'"

NODE = """#!/bin/sh
# One who has a child, and ends with the first signal.
sleep 6001 &
echo node up
wait
"""
DEAF = """
import signal, time
for number in (2, 15): signal.signal(number, signal.SIG_IGN)
print('deaf up')
time.sleep(600)
"""

INNER = f"""
import sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    deaf = [sys.executable, "-c", {DEAF!r}]
    return LaunchDescription([ExecuteProcess(cmd=deaf, name="deaf", output="screen", {TIMEOUTS})])
"""

OUTER = f"""
import sys
from launch import LaunchDescription
from launch.actions import (
    ExecuteProcess, IncludeLaunchDescription, LogInfo, OpaqueFunction, RegisterEventHandler, TimerAction
)
from launch.event_handlers import OnProcessExit
from launch_ros.actions import LifecycleNode, Node

def generate_launch_description():
    node = Node(
        executable={{node!r}}, name="walker", output="screen", parameters=[{{{{"gait": 3}}}}], respawn=True, {TIMEOUTS}
    )
    nodes = [
        LifecycleNode(
            executable=sys.executable, arguments=[{str(SENSOR)!r}], name="sensor", namespace="", output="screen"
        ),
        Node(package="tf2_ros", executable="buffer_server", name="box", output="screen"),
    ] if {{on_wire}} else []
    return LaunchDescription([
        RegisterEventHandler(OnProcessExit(target_action=node, on_exit=[LogInfo(msg="the walker has ended")])),
        IncludeLaunchDescription({{inner!r}}),
        node,
        *nodes,
        TimerAction(period=0.2, actions=[ExecuteProcess(cmd=["sleep", "6002"], name="late", {TIMEOUTS})]),
        TimerAction(period=600.0, actions=[LogInfo(msg="never")]),
    ])
"""

STEPS = {
    "before a process is started": ("All log files", False),
    "while processes start": ("[deaf-1]: process started", False),
    "while all run": ("[late-3]: process started", False),
    "after SIGINT": ("sending signal 'SIGINT' to process[deaf-1]", True),
    "after SIGTERM": ("sending signal 'SIGTERM' to process[deaf-1]", True),
    "after SIGKILL": ("sending signal 'SIGKILL' to process[deaf-1]", True),
}
"""Steps of a launch, each with a text of its first line, and whether the launch has been interrupted for it."""

VICTIMS = {
    "launch": lambda words: "launch" in words and "-m" in words,
    "guardian": lambda words: any(word.endswith("guardian.py") for word in words),
    "node": lambda words: any(word.endswith("/walker") for word in words),
    "child of the node": lambda words: words[-1] == "6001",
    "included process": lambda words: DEAF in words,
    "lifecycle node": lambda words: str(SENSOR) in words,
    "node of a script": lambda words: any(word.endswith("/buffer_server") for word in words),
}


def words_of(process: psutil.Process) -> list[str]:
    """Return the command line of a process; of one that has ended, a word that none has."""
    with suppress(psutil.Error):
        return process.cmdline() or [""]
    return [""]


class Launched:
    """A launch of the test, whose processes are known by an environment variable."""

    def __init__(self, folder: Path, start_program: Callable[..., Program], *, on_wire: bool = False) -> None:
        self.mark = uuid.uuid4().hex
        self._others = set(psutil.pids())
        """Processes of before, whose environments need not be read again and again."""
        self.temporary = folder / "tmp"
        self.temporary.mkdir()
        node = folder / "walker"
        node.write_text(NODE, "utf-8")
        node.chmod(0o755)
        inner, outer = folder / "inner.launch.py", folder / "outer.launch.py"
        inner.write_text(INNER, "utf-8")
        outer.write_text(OUTER.format(node=str(node), inner=str(inner), on_wire=on_wire), "utf-8")
        self.last = 3 + 2 * on_wire
        """Number of the last process of the launch."""
        environment = {**os.environ, MARK: self.mark, "TMPDIR": str(self.temporary)}
        self.program = start_program(sys.executable, "-m", "tfloom", "launch", outer, env=environment)

    def processes(self) -> list[psutil.Process]:
        """Return the processes of the launch that are alive, itself and its guardian included."""
        found = []
        for pid in psutil.pids():
            with suppress(psutil.NoSuchProcess):  # it has ended since
                if pid not in self._others and self._has(pid):
                    found.append(psutil.Process(pid))
        return found

    def _has(self, pid: int) -> bool:
        with suppress(psutil.Error, OSError):  # it has ended
            process = psutil.Process(pid)
            return process.status() != psutil.STATUS_ZOMBIE and process.environ().get(MARK) == self.mark
        return False

    def find(self, victim: str) -> psutil.Process | None:
        is_victim = VICTIMS[victim]
        return next((process for process in self.processes() if is_victim(words_of(process))), None)

    def go_to(self, step: str) -> None:
        text, is_interrupted = STEPS[step]
        if is_interrupted:
            self.program.wait_for("deaf up")
            self.program.wait_for(f"[late-{self.last}]: process started")
            self.program.signal(signal.SIGINT)
        self.program.wait_for(text.replace("late-3", f"late-{self.last}"), timeout_s=END_S)

    def is_gone(self) -> bool:
        return not any(self.temporary.iterdir()) and not self.processes()

    def left(self) -> str:
        return f"{[words_of(process) for process in self.processes()]} {list(self.temporary.iterdir())}"


def kill_at(
    step: str,
    victim: str,
    launched: Launched,
    wait_until: Callable[..., None],
) -> None:
    """Kill a process of a launch at a step, and check all that is left."""
    launched.go_to(step)
    if not STEPS[step][1]:
        wait_until(lambda: launched.find(victim), what=f"the {victim}")
    process = launched.find(victim)
    if process is not None:  # after SIGINT all but the deaf one may have ended
        process.kill()
    program = launched.program
    if victim == "launch":
        assert program.wait(END_S) in (-signal.SIGKILL, 0)
        wait_until(launched.is_gone, END_S, what="the end of all")
        return
    if not STEPS[step][1]:
        if victim == "node":
            program.wait_for(f"process has died [pid {process.pid}, exit code -9, cmd ")
            program.wait_for("the walker has ended")
            wait_until(
                lambda: (again := launched.find("node")) is not None and again.pid != process.pid,
                what="the node that is started again",
            )
        elif victim not in ("guardian", "child of the node"):
            program.wait_for(f"process has died [pid {process.pid}, exit code -9, cmd ")
        program.signal(signal.SIGINT)
    assert program.wait(END_S) == 0, program.output
    assert not [line for line in program.lines if line.startswith("Traceback")]
    assert launched.is_gone(), launched.left()


@pytest.fixture
def launched(tmp_path: Path, start_program: Callable[..., Program]) -> Launched:
    return Launched(tmp_path, start_program)


@pytest.mark.parametrize(
    ("step", "victim"),
    [
        ("before a process is started", "launch"),
        ("while processes start", "launch"),
        ("while all run", "guardian"),
        ("while all run", "node"),
        ("after SIGINT", "launch"),
        ("after SIGTERM", "included process"),
    ],
)
def test_a_process_of_a_launch_is_killed(
    launched: Launched, wait_until: Callable[..., None], step: str, victim: str
) -> None:
    kill_at(step, victim, launched, wait_until)


@pytest.mark.slow
@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("victim", VICTIMS)
def test_each_process_of_a_launch_with_nodes_is_killed_at_each_step(
    domain_id: int,
    tmp_path: Path,
    start_program: Callable[..., Program],
    wait_until: Callable[..., None],
    step: str,
    victim: str,
) -> None:
    kill_at(step, victim, Launched(tmp_path, start_program, on_wire=True), wait_until)


def test_a_node_that_is_killed_often_leaves_no_descriptor(
    launched: Launched, wait_until: Callable[..., None]
) -> None:
    launched.go_to("while all run")
    launch = psutil.Process(launched.program.process.pid)

    def is_started_again(former_pid: int) -> bool:
        node, child = launched.find("node"), launched.find("child of the node")
        if node is None or child is None or node.pid == former_pid:
            return False
        with suppress(psutil.NoSuchProcess):
            return child.ppid() == node.pid
        return False

    def kill_node() -> None:
        node = launched.find("node")
        assert node is not None
        # A child would hold the pipes open, and is ended with the launch; without it the node may end by itself.
        for process in (node, *node.children()):
            with suppress(psutil.NoSuchProcess):
                process.kill()
        # The former child, whose parent is gone, may be seen for a moment.
        wait_until(lambda: is_started_again(node.pid))

    wait_until(lambda: launched.find("child of the node"))
    kill_node()
    descriptors, threads = launch.num_fds(), launch.num_threads()
    for _ in range(5):
        kill_node()
    # The last end may be under way.
    wait_until(lambda: launch.num_fds() <= descriptors, what=f"{descriptors} descriptors")
    wait_until(lambda: launch.num_threads() <= threads, what=f"{threads} threads")
    launched.program.signal(signal.SIGTERM)
    assert launched.program.wait(END_S) == 0
    assert launched.is_gone(), launched.left()
