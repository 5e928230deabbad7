"""The turtlesim and tf2 tutorial from start to end, by its commands: each program a process, over DDS on loopback."""

from __future__ import annotations

import math
import os
import re
import signal
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import COLCON_PYTHON, run_to_end
from tests.workspace.conftest import BIN

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs bash")
TWIST = "{linear: {x: 0.5}, angular: {z: 1.0}}"


def ros2(*words: str) -> str:
    """Run a command to its end and return its output."""
    result = run_to_end([BIN / "ros2", *words], timeout_s=60, stdin=subprocess.DEVNULL)
    assert result.returncode == 0, result.stderr
    return result.stdout


def pose() -> tuple[float, ...]:
    """Return the turtle's x, y [m], theta [rad] and velocities [m/s, rad/s]."""
    return tuple(
        float(value) for value in ros2("topic", "echo", "--once", "--csv", "/turtle1/pose").split(",")
    )


def test_tutorial_runs_from_start_to_end(
    domain_id: int,
    tmp_path: Path,
    start_program: Callable[..., Any],
    built_broadcaster: list[str],
    wait_until: Callable[..., None],
) -> None:
    turtlesim = start_program("ros2", "run", "turtlesim", "turtlesim_node")
    turtlesim.wait_for("Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]")
    driver = start_program(
        *("ros2", "topic", "pub", "--rate", "1", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", TWIST)
    )
    driver.wait_for(
        "publishing #2: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=0.5, y=0.0, z=0.0)"
    )
    assert pose()[3:] == (0.5, 1.0)

    broadcaster = start_program(*built_broadcaster, env=os.environ | COLCON_PYTHON)
    broadcaster.wait_for("[broadcaster]: Broadcasting world to turtle1")
    assert ros2("node", "list").split() == ["/broadcaster", "/turtlesim"]
    assert "/tf" in ros2("topic", "list").split()

    driver.signal(signal.SIGINT)
    assert driver.wait() == 2
    wait_until(lambda: pose()[3:] == (0.0, 0.0))
    x, y, theta, *_ = pose()
    echo = start_program("ros2", "run", "tf2_ros", "tf2_echo", "world", "turtle1")
    echo.wait_for(f"- Translation: [{x:.3f}, {y:.3f}, 0.000]")
    # Beyond a third of a turn, which a turtle can reach on a slow machine, tf2 makes z positive, not w.
    sign = -1.0 if theta < -math.tau / 3 else 1.0
    echo.wait_for(f"[0.000, 0.000, {sign * math.sin(theta / 2):.3f}, {sign * math.cos(theta / 2):.3f}]")
    row = (math.cos(theta), -math.sin(theta), 0.0, x)
    echo.wait_for("".join(f"{value:7.3f}" for value in row))

    pictures = start_program("ros2", "run", "tf2_tools", "view_frames", "--wait-time", "1", cwd=tmp_path)
    assert pictures.wait() == 0
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF-")
    stamped = [path.name for path in tmp_path.iterdir() if re.fullmatch(r"frames_.*\.(gv|pdf)", path.name)]
    assert len(stamped) == 2
    graph = next(tmp_path.glob("frames_*.gv")).read_text()
    assert '"world" -> "turtle1"' in graph

    for program in (broadcaster, echo, turtlesim):
        program.signal(signal.SIGINT)
    assert [program.wait() for program in (echo, turtlesim)] == [0, 0]
    broadcaster.wait()
    assert "Traceback" not in broadcaster.output
